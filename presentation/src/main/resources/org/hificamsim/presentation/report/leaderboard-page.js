// The page of the benchmark's leaderboard: one sortable table of all entries.
import {el} from './dom.js';
import {rowsOf, sortable} from './table.js';

/** The page; `data` is what LeaderboardReport wrote. */
export async function leaderboardPage(root, data) {
  const columns = data.columns.map(name => ({name}));
  root.append(
    el('header', {}, el('h1', {}, 'Cameras that zoom and turn: the leaderboard')),
    el(
      'section',
      {class: 'card'},
      el(
        'p',
        {},
        'Scores from 0, cameras that always zoom out, to 1, the proven optimum of every step.' +
          ' IQM is the interquartile mean over all tasks and testing episodes, with its 95\u00a0%' +
          ' interval by a bootstrap within tasks. Every entry was checked: its actions were' +
          ' played again, and scored the same.',
      ),
      el(
        'div',
        {class: 'scroll', tabindex: 0, role: 'region', 'aria-label': 'Scores'},
        sortable('Scores', columns, rowsOf(data), 'unseen'),
      ),
      el(
        'p',
        {class: 'note'},
        `HiFi-CamSim ${data.version}, ${data.episodes} episodes for each task.`,
      ),
    ),
  );
  root.dataset.ready = '';
}
