// Computes the shares of zones that are covered, and the blind spots, from a heat map.

/**
 * Returns for each zone {zone, covered, twice, never}: the shares of steps in which one or more,
 * and
 * two or more, cameras cover it, and the share of its area that is never covered. Cells in
 * obstacles do not count; the shares are NaN if no cell is left.
 */
export function zoneShares({columns, rows, figures}, {minX, maxX, minY, maxY}, zones) {
  const valuesOf = name => figures.find(figure => figure.name === name).values;
  const [covered, twice] = [valuesOf('covered'), valuesOf('covered-k')];
  const middle = cell => [
    minX + (((cell % columns) + 0.5) * (maxX - minX)) / columns,
    minY + ((Math.floor(cell / columns) + 0.5) * (maxY - minY)) / rows,
  ];
  return zones.map(zone => {
    const cells = [...covered.keys()].filter(
      cell =>
        !Number.isNaN(covered[cell]) && contains(zone, ...middle(cell), (maxX - minX) / columns),
    );
    const mean = value => cells.reduce((sum, cell) => sum + value(cell), 0) / cells.length;
    return {
      zone,
      covered: mean(cell => covered[cell]),
      twice: mean(cell => twice[cell]),
      never: mean(cell => covered[cell] === 0),
    };
  });
}

/** Whether a zone contains a point. A line counts as a strip, `width` metres to either side. */
function contains({shape, points}, x, y, width) {
  if (shape === 'FIELD') return true;
  if (shape === 'RECTANGLE') {
    const [corner, opposite] = points;
    return (x - corner.x) * (x - opposite.x) <= 0 && (y - corner.y) * (y - opposite.y) <= 0;
  }
  const sides = points.map((to, i) => [points.at(i - 1), to]);
  if (shape === 'POLYGON') return sides.filter(side => crossesRay(side, x, y)).length % 2 === 1;
  return sides.slice(1).some(side => distance(side, x, y) <= width);
}

/** Whether a ray from a point to the right crosses a side. */
const crossesRay = ([from, to], x, y) =>
  from.y > y !== to.y > y && x < from.x + ((to.x - from.x) * (y - from.y)) / (to.y - from.y);

/** The distance of a point from a side, in metres. */
function distance([from, to], x, y) {
  const [dx, dy] = [to.x - from.x, to.y - from.y];
  const along = ((x - from.x) * dx + (y - from.y) * dy) / (dx ** 2 + dy ** 2 || 1);
  const share = Math.max(0, Math.min(1, along));
  return Math.hypot(x - from.x - share * dx, y - from.y - share * dy);
}

/**
 * Returns the connected areas that no camera ever covered, the largest first, each with its
 * bounding box and its area in square metres.
 */
export function blindSpots({columns, rows, figures}, {minX, maxX, minY, maxY}) {
  const blind = figures.find(({name}) => name === 'covered').values.map(share => share === 0);
  const [cellWidth, cellHeight] = [(maxX - minX) / columns, (maxY - minY) / rows];
  const spots = [];
  for (let start = 0; start < blind.length; start++) {
    if (!blind[start]) continue;
    const spot = {cells: 0, minX: Infinity, maxX: -Infinity, minY: Infinity, maxY: -Infinity};
    const waiting = [start];
    blind[start] = false;
    while (waiting.length) {
      const cell = waiting.pop();
      const [column, row] = [cell % columns, Math.floor(cell / columns)];
      spot.cells++;
      Object.assign(spot, {
        minX: Math.min(spot.minX, minX + column * cellWidth),
        maxX: Math.max(spot.maxX, minX + (column + 1) * cellWidth),
        minY: Math.min(spot.minY, minY + row * cellHeight),
        maxY: Math.max(spot.maxY, minY + (row + 1) * cellHeight),
      });
      const neighbours = [
        column > 0 && cell - 1,
        column < columns - 1 && cell + 1,
        cell - columns,
        cell + columns,
      ];
      for (const neighbour of neighbours) {
        if (neighbour === false || !blind[neighbour]) continue;
        blind[neighbour] = false;
        waiting.push(neighbour);
      }
    }
    spots.push({...spot, area: spot.cells * cellWidth * cellHeight});
  }
  return spots.sort((a, b) => b.area - a.area);
}
