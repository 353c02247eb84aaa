// Builds the page of the benchmark's leaderboard: each entry's scores as bars, and all numbers.
import {foldedCard, scrollBox, svg} from './cards.js';
import {el} from './dom.js';
import {rowsOf, sortable} from './table.js';

const MISSING = '-';
const SUMMARIES = ['IQM', 'Mean'];
const BAR = {width: 9, gap: 2, height: 34};

/** Builds the page from data that LeaderboardReport wrote. */
export async function leaderboardPage(root, data) {
  const rows = rowsOf(data);
  const isKnown = name => rows.some(row => row[name] !== MISSING);
  const tasks = data.columns.slice(2 + SUMMARIES.length);
  root.append(
    el('header', {}, el('h1', {}, 'Cameras that zoom and turn: the leaderboard')),
    el(
      'section',
      {class: 'card'},
      el(
        'p',
        {},
        'A score of 0 is that of cameras that always zoom out, 1 is the proven optimum of every' +
          ' step. IQM is the interquartile mean over all tasks and testing episodes, with its' +
          ' 95\u00a0% interval by a bootstrap within tasks. Every entry was checked: its actions' +
          ' were played again, and scored the same.',
      ),
      scores(rows, tasks),
      el('p', {class: 'note'}, `Tasks from left to right: ${tasks.join(', ')}.`),
      el(
        'p',
        {class: 'note'},
        `HiFi-CamSim ${data.version}, ${data.episodes} episodes for each task.`,
      ),
    ),
    foldedCard('All numbers', () => numbers(data.columns.filter(isKnown), rows)),
  );
  root.dataset.ready = '';
}

/** The table of scores: for each entry its name, its score over all tasks, and a bar for each. */
function scores(rows, tasks) {
  const line = row =>
    el(
      'tr',
      {},
      el(
        'th',
        {scope: 'row'},
        row.Entry,
        el('small', {class: 'note'}, ` verified by ${row['Verified by']}`),
      ),
      el('td', {}, row.IQM === MISSING ? missingTasks(row, tasks) : row.IQM),
      el('td', {}, bars(row, tasks)),
    );
  const heads = ['entry', 'IQM of all tasks', 'each task'];
  return scrollBox(
    'Scores',
    el(
      'table',
      {class: 'board'},
      el('thead', {}, el('tr', {}, ...heads.map(head => el('th', {scope: 'col'}, head)))),
      el('tbody', {}, ...rows.map(line)),
    ),
  );
}

/** Explains why an entry has no score over all tasks. */
function missingTasks(row, tasks) {
  const count = tasks.filter(task => row[task] !== MISSING).length;
  return el('span', {class: 'note'}, `none: played ${count} of ${tasks.length} tasks`);
}

/** Draws a bar from 0 to 1 for each task, or a dot if the entry has not played the task. */
function bars(row, tasks) {
  const width = tasks.length * (BAR.width + BAR.gap);
  const label = tasks.map(task => `${task} ${row[task]}`).join(', ');
  const parts = tasks.map((task, i) => bar(task, row[task], i * (BAR.width + BAR.gap)));
  const axis = svg('line', {x1: 0, x2: width, y1: BAR.height, y2: BAR.height, class: 'rail'});
  return svg(
    'svg',
    {
      viewBox: `0 0 ${width} ${BAR.height + 1}`,
      width,
      class: 'bars',
      role: 'img',
      'aria-label': label,
    },
    axis,
    ...parts,
  );
}

function bar(task, text, x) {
  const title = svg('title', {}, `${task}: ${text === MISSING ? 'not played' : text}`);
  if (text === MISSING)
    return svg('circle', {cx: x + BAR.width / 2, cy: BAR.height - 4, r: 1.5, class: 'none'}, title);
  const share = Math.min(1, Math.max(0, parseFloat(text)));
  const height = Math.max(1, share * BAR.height);
  const frame = svg('rect', {x, width: BAR.width, y: 0, height: BAR.height, class: 'frame'});
  const filled = svg('rect', {x, width: BAR.width, y: BAR.height - height, height, class: 'score'});
  return svg('g', {}, title, frame, filled);
}

const numbers = (columns, rows) =>
  scrollBox(
    'All numbers',
    sortable(
      'All numbers',
      columns.map(name => ({name})),
      rows,
      'unseen',
    ),
  );
