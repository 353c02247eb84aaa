// Shows one run: the field, its numbers, the selected camera, and charts over time.
import {el} from './dom.js';
import {FieldView} from './field.js';
import {Readout} from './readout.js';
import {AgentPanel} from './agent.js';
import {Timeline} from './timeline.js';
import {TargetForm} from './target-form.js';

export class Player {
  /**
   * @param run a run, recorded or growing
   * @param playhead the playhead, which other players may share
   * @param options `middle`: an element between the field and the timeline;
   *   `edit`: functions that change the site, as {@link PoseForm} and {@link AgentPanel} say;
   *   `draw`: the {@link DrawForm}, if the site can be drawn; `tools`: elements next to the field;
   *   `heat(figure)`: called when one of the heat map's `figures` is chosen, if there can be one;
   *   `ceiling()`: returns a value up to which the axis of k_min reaches at least
   */
  constructor(run, playhead, options = {}) {
    this.run = run;
    this.playhead = playhead;
    const {edit} = options;
    const handlers = {
      select: camera => this.select(camera),
      drag: edit && ((camera, x, y) => edit.move(camera, x, y)),
      ceiling: options.ceiling,
      objective: run.objective,
      following: run.setup.following,
      pick: target => this.targets?.choose(target),
      heat: options.heat,
      figures: options.figures,
      line: ends => options.draw.complete(ends),
      drawing: ends => options.draw.show(ends),
    };
    this.field = new FieldView(run, handlers);
    this.readout = new Readout(run);
    this.agent = new AgentPanel(run, options.edit);
    this.timeline = new Timeline(playhead, handlers);
    this.targets = edit && new TargetForm(run.setup, edit);
    this.agent.element.hidden = !run.setup.cameras.length;
    const tools = [...(options.tools ?? []), this.targets?.element].filter(Boolean);
    this.element = el(
      'div',
      {class: 'player'},
      this.field.element,
      el(
        'div',
        {class: 'side'},
        this.readout.element,
        this.agent.element,
        tools.length ? el('section', {class: 'tools', 'aria-label': 'the site'}, ...tools) : null,
      ),
      options.middle,
      this.timeline.element,
    );
    this.timeline.load(run);
    if (run.setup.cameras.length) this.select(run.busiest());
    playhead.subscribe(frame => this.show(frame));
  }

  /** Selects a camera in all parts; -1, for a click that hit none, changes nothing. */
  select(camera) {
    if (camera < 0) return;
    this.field.set('selected', camera);
    this.agent.select(camera);
    this.timeline.select(camera);
  }

  /** Shows frames that were added to the run. */
  grew() {
    this.timeline.load(this.run);
    this.show(this.playhead.frame);
  }

  show(frame) {
    if (frame >= this.run.count) return;
    this.field.show(frame);
    this.readout.show(frame);
    this.agent.show(frame);
    this.timeline.show(frame);
  }
}
