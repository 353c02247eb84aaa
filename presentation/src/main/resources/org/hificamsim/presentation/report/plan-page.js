// Builds the page of a plan of cameras: the floor plan, what the plan achieves, and its tables.
import {card, madeWith, scrollBox} from './cards.js';
import {el} from './dom.js';
import {rowsOf, sortable} from './table.js';

/** Builds the page from data that PlanSheet wrote. */
export async function planPage(root, data) {
  root.append(el('header', {}, el('h1', {}, data.title)));
  const [met, ...facts] = data.facts;
  root.append(
    el(
      'section',
      {class: 'card'},
      ...data.block.map(([key, value]) => el('p', {}, `${key}: ${value}`)),
      el('p', {}, el('b', {}, met)),
      ...facts.map(fact => el('p', {}, fact)),
      el(
        'p',
        {class: 'note'},
        el('a', {href: 'plan.pdf'}, 'PDF'),
        ', ',
        el('a', {href: 'plan.svg'}, 'floor plan as SVG'),
        ', ',
        el('a', {href: 'plan.dxf'}, 'as DXF'),
        ', ',
        el('a', {href: 'order.csv'}, 'order list'),
      ),
    ),
  );
  root.append(
    card(
      'Floor plan',
      el(
        'a',
        {href: 'plan.svg'},
        picture(
          data.floor,
          'The floor plan to scale with the cameras, what they look at, ' +
            'and the cells by how they are seen',
        ),
      ),
    ),
  );
  if (data.levels) {
    root.append(
      card(
        'Levels reached',
        el(
          'a',
          {href: 'levels.svg'},
          picture(
            data.levels,
            'The floor plan with the cells by the highest level that a camera reaches there',
          ),
        ),
      ),
    );
  }
  for (const table of data.tables.filter(({rows}) => rows.length)) {
    const columns = table.columns.map(name => ({name}));
    root.append(
      card(
        table.title,
        scrollBox(table.title, sortable(table.title, columns, rowsOf(table), 'unseen')),
      ),
    );
  }
  if (data.curve) {
    root.append(
      card(
        'What each camera adds',
        picture(
          data.curve,
          'The share of the samples that the first cameras meet, over their price or number, ' +
            'and the most that any plan can meet',
        ),
      ),
    );
  }
  root.append(madeWith(data));
  root.dataset.ready = '';
}

const picture = (src, alt) =>
  el('div', {class: 'pictures'}, el('figure', {class: 'wide'}, el('img', {src, alt})));
