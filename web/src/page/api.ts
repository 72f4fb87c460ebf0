// What the page asks of the server by HTTP, each answer typed; refusals are errors with the server's own words.

import type {
  Design, Document, Elements, FileJob, FileWish, Material, PlotData, Problem, Texts,
} from "./protocol";

// A problem in a line; what is about nothing in particular has no subject.
export const lineOf = ({ subject, message }: Problem) => (subject ? `${subject}: ${message}` : message);

export class ApiError extends Error {
  constructor(readonly headline: string, readonly problems: Problem[], readonly status: number) {
    super([headline, ...problems.map(lineOf)].join("\n"));
  }
}

export class Api {
  constructor(private readonly base: string = "api/") {}

  elements(): Promise<Elements> {
    return this.got("elements");
  }

  materials(): Promise<Material[]> {
    return this.got("materials");
  }

  async read(toml: string): Promise<Design> {
    return (await this.sent<{ design: Design }>("read", { toml })).design;
  }

  texts(design: Design): Promise<Texts> {
    return this.sent("texts", { design });
  }

  build(design: Design, density: number | null, material: string | null): Promise<Document> {
    return this.sent("build", { design, density, material });
  }

  plot(design: Design, plot: string, signal?: AbortSignal): Promise<PlotData> {
    return this.sent("plots", { design, plot }, signal);
  }

  startFile(wish: FileWish): Promise<{ id: string; url: string }> {
    return this.sent("files", wish);
  }

  file(id: string): Promise<FileJob> {
    return this.got(`files/${encodeURIComponent(id)}`);
  }

  async cancelFile(id: string): Promise<void> {
    await this.answered(`files/${encodeURIComponent(id)}`, { method: "DELETE" });
  }

  // The value that stands in the design where a file name would.
  async upload(file: File): Promise<{ value: string; name: string; bytes: number }> {
    const made = await this.answered(`uploads?name=${encodeURIComponent(file.name)}`, { method: "POST", body: file });
    return made.json() as Promise<{ value: string; name: string; bytes: number }>;
  }

  private async got<T>(path: string): Promise<T> {
    return (await this.answered(path)).json() as Promise<T>;
  }

  private async sent<T>(path: string, body: unknown, signal?: AbortSignal): Promise<T> {
    const headers = { "Content-Type": "application/json" };
    const options: RequestInit = { method: "POST", headers, body: JSON.stringify(body), signal: signal ?? null };
    return (await this.answered(path, options)).json() as Promise<T>;
  }

  private async answered(path: string, options: RequestInit = {}): Promise<Response> {
    let response: Response;
    try {
      response = await fetch(this.base + path, options);
    } catch {
      throw new ApiError("The server does not answer; is it still running?", [], 0);
    }
    if (response.ok) return response;
    const told = await response.json().catch(() => null) as { headline?: string; problems?: Problem[] } | null;
    throw new ApiError(told?.headline ?? `The server answers ${response.status}`, told?.problems ?? [], response.status);
  }
}
