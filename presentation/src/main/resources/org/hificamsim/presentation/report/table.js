// Tables that a click on a column's head sorts; a second click reverses the order.
import {el} from './dom.js';

const AS_WORDS = new Intl.Collator('en', {numeric: true});

/** Compares texts: numbers by value, others as words, missing ones last. */
function order(a, b) {
  if (a === '' || b === '') return (a === '') - (b === '');
  const [x, y] = [Number(a), Number(b)];
  return Number.isNaN(x) || Number.isNaN(y) ? AS_WORDS.compare(a, b) : x - y;
}

/**
 * Returns a table element.
 * @param caption the text of the caption
 * @param columns objects {name, label?, title?, show?}: `show(text, row)` returns the content of a
 *   cell, by default the text itself
 * @param rows objects of texts by column name
 * @param captionClass `unseen` if a heading already says what the caption says
 */
export function sortable(caption, columns, rows, captionClass) {
  const body = el('tbody');
  const heads = columns.map((column, i) =>
    el(
      'th',
      {
        scope: 'col',
        'aria-sort': 'none',
        class: rows.some(row => isNumber(row[column.name] ?? '')) ? 'number' : null,
      },
      el(
        'button',
        {type: 'button', title: column.title, onclick: () => sort(i)},
        column.label || column.name,
      ),
    ),
  );
  const lines = rows.map(row => ({row, element: line(columns, row)}));
  body.append(...lines.map(({element}) => element));

  function sort(i) {
    const up = heads[i].getAttribute('aria-sort') !== 'ascending';
    heads.forEach((head, j) =>
      head.setAttribute('aria-sort', j === i ? (up ? 'ascending' : 'descending') : 'none'),
    );
    const {name} = columns[i];
    const sorted = [...lines].sort((a, b) => {
      const [x, y] = [a.row[name], b.row[name]];
      return (up || x === '' || y === '' ? 1 : -1) * order(x, y);
    });
    body.replaceChildren(...sorted.map(({element}) => element));
  }

  return el(
    'table',
    {class: 'sortable'},
    el('caption', {class: captionClass}, caption),
    el('thead', {}, el('tr', {}, ...heads)),
    body,
  );
}

function line(columns, row) {
  return el(
    'tr',
    {},
    ...columns.map(({name, show}) => {
      const text = row[name] ?? '';
      return el(
        'td',
        {
          class: isNumber(text) ? 'number' : text.length > 40 ? 'long' : null,
          title: text,
          data: {column: name, text},
        },
        show ? show(text, row) : text,
      );
    }),
  );
}

const isNumber = text => text !== '' && !Number.isNaN(Number(text.replace(/ %$/, '')));

/** Returns the rows of a table {columns, rows} as objects by column name. */
export const rowsOf = table =>
  table.rows.map(cells => Object.fromEntries(table.columns.map((name, i) => [name, cells[i]])));

/** The different texts of a column, in the order of the rows. */
export const distinct = (rows, name) => [...new Set(rows.map(row => row[name]))];
