// What the pointer does in a field: it selects, drags cameras, draws, and moves the map.

const REACH = 16; // pixels between the pointer and what it points at
const STILL = 3; // pixels that a press may move before it drags

export class FieldPointer {
  /**
   * @param field the FieldView
   * @param on as in FieldView
   */
  constructor(field, on) {
    this.field = field;
    this.on = on;
    this.place = null; // in pixels; null while the pointer is elsewhere
    this.line = null; // what is being drawn: x and y of both its places in metres
    this.clicked = false; // whether a click has begun it, so that the next press ends it
    const {canvas} = field.surface;
    canvas.addEventListener('pointerdown', event => this.onPress(event));
    canvas.addEventListener('pointermove', event => this.onMove(event));
    canvas.addEventListener('pointerup', () => this.onRelease(true));
    canvas.addEventListener('pointercancel', () => this.onRelease(false));
    canvas.addEventListener('pointerleave', () => {
      this.place = null;
      field.tooltip.hide();
    });
  }

  onPress(event) {
    if (event.button !== 0) return;
    const {field, on} = this;
    this.place = [event.offsetX, event.offsetY];
    if (field.drawing) {
      this.beginLine();
      field.surface.canvas.setPointerCapture(event.pointerId);
      return;
    }
    const {camera, target} = this.nearest();
    on.select(camera);
    if (camera < 0 && target >= 0) on.pick(target);
    if (camera >= 0 && on.drag) this.grab(camera);
    else if (camera < 0 && field.magnifier.times > 1)
      this.mapDrag = {from: this.place, left: field.magnifier.left, top: field.magnifier.top};
    else return;
    field.surface.canvas.setPointerCapture(event.pointerId);
  }

  grab(camera) {
    const {run, frame, map} = this.field;
    const pose = run.pose(camera, frame);
    const centre = [map.x(pose.x), map.y(pose.y)];
    this.cameraDrag = {camera, from: this.place, centre, moves: false};
  }

  onMove(event) {
    this.place = [event.offsetX, event.offsetY];
    if (this.cameraDrag) this.dragCamera(this.cameraDrag);
    if (this.mapDrag) this.dragMap(this.mapDrag);
    if (this.line) this.extendLine();
    this.field.describe();
  }

  /** Moves the camera as far as the pointer has moved, so that it does not jump to the pointer. */
  dragCamera(drag) {
    const [right, down] = this.place.map((pixel, i) => pixel - drag.from[i]);
    drag.moves ||= Math.hypot(right, down) >= STILL;
    if (!drag.moves) return;
    const place = this.field.map.place(drag.centre[0] + right, drag.centre[1] + down);
    this.on.drag(drag.camera, ...place);
  }

  dragMap({from, left, top}) {
    const [right, down] = this.place.map((pixel, i) => pixel - from[i]);
    this.field.magnifier.look(this.field.magnifier.times, left + right, top + down);
  }

  /** Begins what is drawn, or ends what a click has begun. */
  beginLine() {
    const place = this.field.map.place(...this.place);
    if (this.clicked) this.line.splice(2, 2, ...place);
    else this.line = [...place, ...place];
  }

  extendLine() {
    this.line.splice(2, 2, ...this.field.map.place(...this.place));
    this.on.drawing(this.line);
    this.field.surface.draw();
  }

  /** Ends a drag. What is drawn is complete, unless a click has just begun it. */
  onRelease(complete) {
    this.cameraDrag = this.mapDrag = null;
    const {line} = this;
    if (line) {
      const [x1, y1, x2, y2] = line;
      const isClick = this.field.map.scale * Math.hypot(x2 - x1, y2 - y1) < STILL;
      this.clicked = complete && isClick && !this.clicked;
      if (!this.clicked) this.line = null;
      if (complete && !isClick) this.on.line(line);
    }
    this.field.surface.draw();
  }

  /** Forgets what is being drawn. */
  forgetLine() {
    this.line = null;
    this.clicked = false;
  }

  /** The camera and the target under the pointer; -1 for none. */
  nearest() {
    const {run, frame} = this.field;
    const {cameras, targets} = run.setup;
    return {
      camera: this.nearestOf(cameras, camera => run.pose(camera, frame)),
      target: this.nearestOf(targets, target =>
        run.present[target][frame] ? {x: run.x[target][frame], y: run.y[target][frame]} : null,
      ),
    };
  }

  /** The index of what is nearest to the pointer, -1 if it is out of reach. */
  nearestOf(list, placeOf) {
    const {map, surface} = this.field;
    const [px, py] = this.place;
    let nearest = -1;
    let least = REACH * surface.unit;
    list.forEach((entry, i) => {
      const place = placeOf(i);
      const distance = place ? Math.hypot(map.x(place.x) - px, map.y(place.y) - py) : Infinity;
      if (distance < least) [least, nearest] = [distance, i];
    });
    return nearest;
  }
}
