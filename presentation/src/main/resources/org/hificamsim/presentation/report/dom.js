// Elements. Text goes in as text nodes alone: names from scenario files are not trusted.

/** An element; attributes whose name starts with "on" are listeners, `data` is its data set. */
export function el(tag, attributes = {}, ...children) {
  const element = document.createElement(tag);
  for (const [name, value] of Object.entries(attributes)) {
    if (name.startsWith('on')) element.addEventListener(name.slice(2), value);
    else if (name === 'data') Object.assign(element.dataset, value);
    else if (value === true) element.setAttribute(name, '');
    else if (value !== false && value != null) element.setAttribute(name, value);
  }
  element.append(...children.filter(child => child != null));
  return element;
}

/** Sets an element's text, if it is another one. */
export function say(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** The page's unit of length in CSS pixels: drawings grow with the text. */
export const rem = () => parseFloat(getComputedStyle(document.documentElement).fontSize);

/** A canvas that fills its element, with `paint(context, width, height)` in CSS pixels at each change of size. */
export class Surface {
  constructor(attributes, paint) {
    this.canvas = el('canvas', attributes);
    this.paint = paint;
    this.observer = new ResizeObserver(() => requestAnimationFrame(() => this.resize()));
    this.observer.observe(this.canvas);
  }

  resize() {
    const box = this.canvas.getBoundingClientRect();
    this.ratio = window.devicePixelRatio || 1;
    this.width = box.width;
    this.height = box.height;
    this.canvas.width = Math.max(1, Math.round(box.width * this.ratio));
    this.canvas.height = Math.max(1, Math.round(box.height * this.ratio));
    this.unit = rem() / 14;
    this.changed = true;
    this.draw();
  }

  draw() {
    if (!this.width || !this.height) return;
    const context = this.canvas.getContext('2d');
    context.resetTransform(); // the last pixels too, within which width and height may end
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.paint(context, this.width, this.height);
  }
}

/** A colour of the style sheet, by the name of its property. */
export const style = name =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

/** Calls back when the page turns dark or light. */
export function onThemeChange(callback) {
  matchMedia('(prefers-color-scheme: dark)').addEventListener('change', callback);
}

/** Starts the page with its data; a fault is shown on the page. */
export async function start(page) {
  const root = document.getElementById('page');
  root.replaceChildren();
  try {
    await page(root, JSON.parse(document.getElementById('data').textContent));
  } catch (fault) {
    root.append(
      el('p', {class: 'notice', role: 'alert'}, `This page could not be drawn: ${fault.message}`),
    );
    throw fault;
  }
}
