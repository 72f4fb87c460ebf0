// Pictures that a view has drawn, measured in the page.

export const settled = (page) =>
  page.evaluate(() => new Promise((done) => requestAnimationFrame(() => requestAnimationFrame(() => setTimeout(done, 50)))));

// The picture kept in the page under a name.
export async function keep(page, name) {
  await settled(page);
  await page.evaluate((name) => {
    const canvas = document.querySelector("canvas");
    const copy = new OffscreenCanvas(canvas.width, canvas.height);
    const pen = copy.getContext("2d");
    pen.drawImage(canvas, 0, 0);
    (window.kept ??= {})[name] = pen.getImageData(0, 0, canvas.width, canvas.height).data;
  }, name);
}

// Share of the pixels that differ by more than a tenth between two pictures.
export const difference = (page, one, other) =>
  page.evaluate(([one, other]) => {
    const [a, b] = [window.kept[one], window.kept[other]];
    let unlike = 0;
    for (let i = 0; i < a.length; i += 4) {
      if ([0, 1, 2, 3].some((k) => Math.abs(a[i + k] - b[i + k]) > 25)) unlike++;
    }
    return unlike / (a.length / 4);
  }, [one, other]);

// How many pixels of a picture, the corner of the axes apart, are opaque and satisfy a test given as the text of r, g, b.
export const count = (page, name, text) =>
  page.evaluate(([name, text]) => {
    const wanted = new Function("r", "g", "b", `return ${text}`);
    const canvas = document.querySelector("canvas");
    const data = window.kept[name];
    let found = 0;
    for (let y = 0; y < canvas.height; y++) {
      for (let x = 0; x < canvas.width; x++) {
        const i = 4 * (y * canvas.width + x);
        const corner = x < 110 && y > canvas.height - 110;
        if (!corner && data[i + 3] > 250 && wanted(data[i], data[i + 1], data[i + 2])) found++;
      }
    }
    return found;
  }, [name, text]);

export const ANY = "true";

export async function slide(page, label, value) {
  await page.getByLabel(label).evaluate((input, value) => {
    input.value = value;
    input.dispatchEvent(new Event("input"));
  }, `${value}`);
}

// Length units a pixel, by the bar.
export async function unitsAPixel(page) {
  const text = await page.locator(".scale").innerText();
  const width = await page.locator(".bar").evaluate((bar) => bar.getBoundingClientRect().width);
  return parseFloat(text) / width;
}
