// The colours of policies on dark pages, where dark ones could not be told from the paper.

const LEAST_CONTRAST = 3; // WCAG 2.2, 1.4.11
const DARK_PAPER = [26, 34, 43];
const STEP = 0.05;

/** A colour for dark pages: greys are inverted, so that order stays; all are light enough. */
export function onDark(colour) {
  const channels = channelsOf(colour);
  const isGrey = new Set(channels).size === 1;
  const start = isGrey ? channels.map(channel => 255 - channel) : channels;
  for (let share = 0; ; share += STEP) {
    const lighter = start.map(channel => Math.round(channel + share * (255 - channel)));
    if (contrast(lighter, DARK_PAPER) >= LEAST_CONTRAST) return `rgb(${lighter})`;
  }
}

/** A colour #rrggbb in the form of a style in a picture. */
export const rgb = colour => `rgb(${channelsOf(colour)})`;

const channelsOf = colour =>
  [1, 3, 5].map(start => Number.parseInt(colour.slice(start, start + 2), 16));

/** The contrast of a lighter colour to a darker one, as WCAG defines it. */
const contrast = (lighter, darker) => (luminance(lighter) + 0.05) / (luminance(darker) + 0.05);

function luminance(channels) {
  const [red, green, blue] = channels
    .map(channel => channel / 255)
    .map(share => (share <= 0.04045 ? share / 12.92 : ((share + 0.055) / 1.055) ** 2.4));
  return 0.2126 * red + 0.7152 * green + 0.0722 * blue;
}
