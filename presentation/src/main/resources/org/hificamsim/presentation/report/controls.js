// The controls of a playhead: buttons, a slider and keys that play, step and change the speed.
import {el, setText} from './dom.js';
import {SPEEDS} from './playhead.js';

const ICONS = {
  first: 'M1 1h2v10H1zM11 1v10L4 6z',
  back: 'M9 1v10L2 6z',
  play: 'M2 0v12l9-6z',
  pause: 'M2 1h3v10H2zM7 1h3v10H7z',
  on: 'M3 1v10l7-5z',
  last: 'M9 1h2v10H9zM1 1v10l7-5z',
};
const KEYS =
  'Keys: space plays and pauses, arrows step (with shift by 10), Home and End jump, ' +
  '+ and - change the speed.';

export class Controls {
  /**
   * @param run the run whose frames the playhead shows
   */
  constructor(playhead, run) {
    this.playhead = playhead;
    this.run = run;
    this.playButton = this.button('play', 'play', () => playhead.toggle());
    this.playButton.classList.add('play');
    this.slider = el('input', {
      type: 'range',
      min: 0,
      max: 0,
      step: 1,
      value: 0,
      'aria-label': 'step',
      oninput: () => {
        playhead.pause();
        playhead.show(Number(this.slider.value));
      },
    });
    this.step = el('output', {class: 'step', data: {name: 'step'}});
    this.total = el('span', {class: 'of'});
    this.speed = el(
      'select',
      {'aria-label': 'steps per second', onchange: () => this.setSpeed()},
      ...SPEEDS.map(speed => el('option', {value: speed}, `${speed} per s`)),
    );
    this.element = el(
      'section',
      {class: 'controls', 'aria-label': 'playing', title: KEYS},
      this.button('first', 'first step', () => playhead.move(-Infinity)),
      this.button('back', 'one step back', () => playhead.move(-1)),
      this.playButton,
      this.button('on', 'one step on', () => playhead.move(1)),
      this.button('last', 'last step', () => playhead.move(Infinity)),
      this.slider,
      el('span', {class: 'count'}, 'step ', this.step, this.total),
      this.speed,
    );
    playhead.subscribe(frame => this.show(frame));
  }

  button(icon, label, onclick) {
    return el(
      'button',
      {type: 'button', 'aria-label': label, title: label, onclick},
      drawing(icon),
    );
  }

  setSpeed() {
    this.playhead.speed = Number(this.speed.value);
    this.playhead.notify();
  }

  show(frame) {
    const {playhead, run} = this;
    const step = run.count ? run.step[frame] : 0;
    this.slider.max = String(Math.max(0, playhead.count - 1));
    this.slider.value = String(frame);
    this.slider.setAttribute('aria-valuetext', `step ${step}`);
    setText(this.step, String(step));
    setText(this.total, ` of ${Math.max(0, run.steps - 1)}`);
    if (this.playing !== playhead.playing) this.showPlaying(playhead.playing);
    this.speed.value = String(playhead.speed);
  }

  showPlaying(playing) {
    this.playing = playing;
    const label = playing ? 'pause' : 'play';
    this.playButton.replaceChildren(drawing(label));
    this.playButton.setAttribute('aria-label', label);
  }

  listen() {
    onKeys(event => this.actionOf(event));
  }

  /** Returns the function that a key calls; undefined if it has none. */
  actionOf({key, shiftKey}) {
    const {playhead} = this;
    const steps = shiftKey ? 10 : 1;
    return {
      ' ': () => playhead.toggle(),
      ArrowRight: () => playhead.move(steps),
      ArrowLeft: () => playhead.move(-steps),
      Home: () => playhead.move(-Infinity),
      End: () => playhead.move(Infinity),
      '+': () => playhead.changeSpeed(1),
      '=': () => playhead.changeSpeed(1),
      '-': () => playhead.changeSpeed(-1),
    }[key];
  }
}

/**
 * Handles keys anywhere on the page, except those that the focused control uses itself.
 * @param actionOf returns the function that an event's key calls, or nothing
 */
export function onKeys(actionOf) {
  document.addEventListener('keydown', event => {
    const tag = event.target.tagName;
    if (event.ctrlKey || event.altKey || event.metaKey || tag === 'SELECT' || tag === 'TEXTAREA')
      return;
    if (tag === 'INPUT' && (event.target.type !== 'range' || event.target.dataset.keys === 'own'))
      return;
    if (event.key === ' ' && (tag === 'BUTTON' || tag === 'SUMMARY')) return;
    const action = actionOf(event);
    if (!action) return;
    action();
    event.preventDefault();
  });
}

/** Draws an icon as SVG, because some fonts lack the character. */
function drawing(icon) {
  const [svg, path] = ['svg', 'path'].map(tag =>
    document.createElementNS('http://www.w3.org/2000/svg', tag),
  );
  svg.setAttribute('viewBox', '0 0 12 12');
  svg.setAttribute('aria-hidden', 'true');
  path.setAttribute('d', ICONS[icon]);
  svg.append(path);
  return svg;
}
