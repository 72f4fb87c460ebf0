// Design files dropped on the page.

export function listenForFiles(host: HTMLElement, open: (file: File) => void): void {
  const holds = (event: DragEvent) => event.dataTransfer?.types.includes("Files") ?? false;
  host.addEventListener("dragover", (event) => {
    if (!holds(event)) return;
    event.preventDefault();
    host.classList.add("dropping");
  });
  host.addEventListener("dragleave", (event) => {
    if (!event.relatedTarget) host.classList.remove("dropping");
  });
  host.addEventListener("drop", (event) => {
    host.classList.remove("dropping");
    const file = event.dataTransfer?.files[0];
    if (!file || (event.target as Element).closest("input[type=file]")) return;
    event.preventDefault();
    open(file);
  });
}
