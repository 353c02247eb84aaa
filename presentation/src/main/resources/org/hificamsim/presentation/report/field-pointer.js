// Handles the pointer in a field: it selects and drags cameras, draws, and moves the map.

const REACH = 16; // pixels; nothing farther from the pointer is pointed at
const CLICK_DISTANCE = 3; // pixels; a press that moves less is a click and not a drag

export class FieldPointer {
  /**
   * @param field the FieldView
   * @param handlers as in FieldView
   */
  constructor(field, handlers) {
    this.field = field;
    this.handlers = handlers;
    this.position = null; // in pixels; null while the pointer is elsewhere
    this.ends = null; // of the outline that is being drawn: x1, y1, x2 and y2 in metres
    this.endsWithPress = false; // whether a click began the outline, so that the next press ends it
    const {canvas} = field.surface;
    canvas.addEventListener('pointerdown', event => this.onPress(event));
    canvas.addEventListener('pointermove', event => this.onMove(event));
    canvas.addEventListener('pointerup', () => this.onRelease(true));
    canvas.addEventListener('pointercancel', () => this.onRelease(false));
    canvas.addEventListener('pointerleave', () => {
      this.position = null;
      field.tooltip.hide();
    });
  }

  onPress(event) {
    if (event.button !== 0) return;
    const {field, handlers} = this;
    this.position = [event.offsetX, event.offsetY];
    if (field.drawing) {
      this.beginOutline();
      field.surface.canvas.setPointerCapture(event.pointerId);
      return;
    }
    const {camera, target} = this.nearest();
    handlers.select(camera);
    if (camera < 0 && target >= 0) handlers.pick(target);
    if (camera >= 0 && handlers.drag) this.grab(camera);
    else if (camera < 0 && field.magnifier.times > 1)
      this.mapDrag = {from: this.position, left: field.magnifier.left, top: field.magnifier.top};
    else return;
    field.surface.canvas.setPointerCapture(event.pointerId);
  }

  grab(camera) {
    const {run, frame, map} = this.field;
    const pose = run.pose(camera, frame);
    const centre = [map.x(pose.x), map.y(pose.y)];
    this.cameraDrag = {camera, from: this.position, centre, moves: false};
  }

  onMove(event) {
    this.position = [event.offsetX, event.offsetY];
    if (this.cameraDrag) this.dragCamera(this.cameraDrag);
    if (this.mapDrag) this.dragMap(this.mapDrag);
    if (this.ends) this.extendOutline();
    this.field.describe();
  }

  /** Moves the camera as far as the pointer has moved, so that it does not jump to the pointer. */
  dragCamera(drag) {
    const [right, down] = this.position.map((pixel, i) => pixel - drag.from[i]);
    drag.moves ||= Math.hypot(right, down) >= CLICK_DISTANCE;
    if (!drag.moves) return;
    const position = this.field.map.place(drag.centre[0] + right, drag.centre[1] + down);
    this.handlers.drag(drag.camera, ...position);
  }

  dragMap({from, left, top}) {
    const [right, down] = this.position.map((pixel, i) => pixel - from[i]);
    this.field.magnifier.look(this.field.magnifier.times, left + right, top + down);
  }

  /** Begins an outline, or sets the second end of one that a click has begun. */
  beginOutline() {
    const position = this.field.map.place(...this.position);
    if (this.endsWithPress) this.ends.splice(2, 2, ...position);
    else this.ends = [...position, ...position];
  }

  extendOutline() {
    this.ends.splice(2, 2, ...this.field.map.place(...this.position));
    this.handlers.drawing(this.ends);
    this.field.surface.draw();
  }

  /** Ends a drag, and an outline unless a click has just begun it. */
  onRelease(complete) {
    this.cameraDrag = this.mapDrag = null;
    const {ends} = this;
    if (ends) {
      const [x1, y1, x2, y2] = ends;
      const isClick = this.field.map.scale * Math.hypot(x2 - x1, y2 - y1) < CLICK_DISTANCE;
      this.endsWithPress = complete && isClick && !this.endsWithPress;
      if (!this.endsWithPress) this.ends = null;
      if (complete && !isClick) this.handlers.line(ends);
    }
    this.field.surface.draw();
  }

  /** Forgets the outline that is being drawn. */
  forgetOutline() {
    this.ends = null;
    this.endsWithPress = false;
  }

  /** The camera and the target under the pointer, {camera, target}; -1 for none. */
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

  /** The index of the entry nearest to the pointer; -1 if none is within reach. */
  nearestOf(list, positionOf) {
    const {map, surface} = this.field;
    const [px, py] = this.position;
    let nearest = -1;
    let least = REACH * surface.unit;
    list.forEach((entry, i) => {
      const position = positionOf(i);
      const distance = position
        ? Math.hypot(map.x(position.x) - px, map.y(position.y) - py)
        : Infinity;
      if (distance < least) [least, nearest] = [distance, i];
    });
    return nearest;
  }
}
