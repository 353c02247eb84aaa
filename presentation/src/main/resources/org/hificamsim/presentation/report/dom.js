// Creates elements. Text becomes text nodes, because names from scenario files are not trusted.

/**
 * Returns an element. Attributes that start with "on" are listeners, `data` is an object of data
 * attributes; children that are null are left out.
 */
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

/** Sets an element's text, unless it is the same already. */
export function setText(element, text) {
  if (element.textContent !== text) element.textContent = text;
}

/** The page's unit of length in CSS pixels: drawings grow with the text. */
export const rem = () => parseFloat(getComputedStyle(document.documentElement).fontSize);

/**
 * A canvas that calls `paint(context, width, height)`, in CSS pixels, whenever its size changes.
 * `unit` is the factor by which drawings grow with the text.
 */
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
    context.resetTransform(); // clears all pixels: width and height may be fractions
    context.clearRect(0, 0, this.canvas.width, this.canvas.height);
    context.setTransform(this.ratio, 0, 0, this.ratio, 0, 0);
    this.paint(context, this.width, this.height);
  }
}

/** Returns the value of a custom property of the style sheet, such as the colour `--ink`. */
export const style = name =>
  getComputedStyle(document.documentElement).getPropertyValue(name).trim();

const darkness = () => matchMedia('(prefers-color-scheme: dark)');

export const isDark = () => darkness().matches;

/** Calls back when the page turns dark or light. */
export function onThemeChange(callback) {
  darkness().addEventListener('change', callback);
}

/** Builds a page from the data in it, `page(root, data)`; an error is shown on the page. */
export async function start(page) {
  const root = document.getElementById('page');
  root.replaceChildren();
  try {
    await page(root, JSON.parse(document.getElementById('data').textContent));
  } catch (error) {
    root.append(
      el('p', {class: 'notice', role: 'alert'}, `This page could not be drawn: ${error.message}`),
    );
    throw error;
  }
}
