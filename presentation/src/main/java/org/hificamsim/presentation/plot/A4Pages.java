package org.hificamsim.presentation.plot;

import java.awt.Font;
import java.awt.Graphics2D;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;

/** Fills numbered A4 pages from top to bottom with texts, pictures and tables. */
public final class A4Pages {
  /** The width of a page, in points, as are all lengths here. */
  private static final int WIDTH = 595;

  private static final int HEIGHT = 842;
  private static final int MARGIN = 42;
  private static final int CONTENT_WIDTH = WIDTH - 2 * MARGIN;
  private static final int LINE = 14;
  private static final int COLUMN_GAP = 12;

  private record Block(int top, Paintable content) {}

  private final List<List<Block>> pages = new ArrayList<>();
  private final String footer;

  /** The top of the next block. It begins at the bottom, so that the first block begins a page. */
  private int top = HEIGHT;

  /**
   * @param footer the text before the number of each page
   */
  public A4Pages(String footer) {
    this.footer = footer;
  }

  /** Adds a heading, and keeps it on one page with what follows. */
  public void heading(String text) {
    if (top + 5 * LINE > HEIGHT - MARGIN) {
      top = HEIGHT;
    }
    add(lines(List.of(text), Fonts.TITLE, 2 * LINE));
  }

  /** Adds lines of text; lines that are too long are broken. */
  public void text(List<String> lines) {
    for (String line : lines) {
      for (String part : Fonts.lines(line, Fonts.TEXT, CONTENT_WIDTH)) {
        add(lines(List.of(part), Fonts.TEXT, LINE));
      }
    }
  }

  /**
   * Adds a picture.
   *
   * @param share the greatest share of the page's height that the picture takes
   */
  public void picture(Paintable picture, double share) {
    double scale = scale(picture, share);
    add(
        new Drawn(
            (int) Math.ceil(scale * picture.height()) + LINE,
            graphics -> {
              graphics.scale(scale, scale);
              picture.paint(graphics);
            }));
  }

  /** Adds a picture below its title, on the same page. */
  public void picture(String title, Paintable picture, double share) {
    double height = scale(picture, share) * picture.height();
    if (top + 3 * LINE + height > HEIGHT - MARGIN) {
      top = HEIGHT;
    }
    heading(title);
    picture(picture, share);
  }

  /** Returns the scale at which {@link #picture} prints. */
  public static double scale(Paintable picture, double share) {
    return Math.min((double) CONTENT_WIDTH / picture.width(), share * HEIGHT / picture.height());
  }

  /**
   * Adds a table below its title. A table that fits on a page is not broken; that of several pages
   * has its head on each of them, and no row alone on a page.
   */
  public void table(String title, List<String> columns, List<List<String>> rows) {
    int[] widths = widths(columns, rows);
    int height = 2 * LINE + (rows.size() + 1) * LINE;
    boolean fitsOnOnePage = height <= HEIGHT - 2 * MARGIN;
    if (top + Math.min(height, fitsOnOnePage ? height : 5 * LINE) > HEIGHT - MARGIN) {
      top = HEIGHT;
    }
    heading(title);
    Paintable head = row(columns, widths, Fonts.PANEL);
    add(head);
    for (int number = 0; number < rows.size(); number++) {
      int needed = number == rows.size() - 2 ? 2 * LINE : LINE;
      if (top + needed > HEIGHT - MARGIN) {
        top = HEIGHT;
        add(head);
      }
      add(row(rows.get(number), widths, Fonts.TICKS));
    }
    top += LINE;
  }

  private static int[] widths(List<String> columns, List<List<String>> rows) {
    return IntStream.range(0, columns.size())
        .map(
            i ->
                Math.max(
                    Fonts.width(columns.get(i), Fonts.PANEL),
                    rows.stream()
                        .mapToInt(row -> Fonts.width(row.get(i), Fonts.TICKS))
                        .max()
                        .orElse(0)))
        .toArray();
  }

  /** Returns a row of a table, which is scaled down if it is too wide. */
  private static Paintable row(List<String> cells, int[] widths, Font font) {
    double scale =
        Math.min(
            1, (double) CONTENT_WIDTH / (IntStream.of(widths).sum() + COLUMN_GAP * widths.length));
    return new Drawn(
        LINE,
        graphics -> {
          graphics.scale(scale, scale);
          graphics.setFont(font);
          graphics.setColor(Palette.BLACK);
          int left = 0;
          for (int i = 0; i < widths.length; i++) {
            graphics.drawString(cells.get(i), left, LINE - 3);
            left += widths[i] + COLUMN_GAP;
          }
        });
  }

  private static Paintable lines(List<String> lines, Font font, int height) {
    return new Drawn(
        height * lines.size(),
        graphics -> {
          graphics.setFont(font);
          graphics.setColor(Palette.BLACK);
          for (int i = 0; i < lines.size(); i++) {
            graphics.drawString(lines.get(i), 0, height * (i + 1) - 4);
          }
        });
  }

  private void add(Paintable content) {
    if (top + content.height() > HEIGHT - MARGIN) {
      pages.add(new ArrayList<>());
      top = MARGIN;
    }
    pages.get(pages.size() - 1).add(new Block(top, content));
    top += content.height();
  }

  /** The pages. */
  public List<Paintable> pages() {
    return IntStream.range(0, pages.size()).mapToObj(this::page).toList();
  }

  private Paintable page(int number) {
    return new Drawn(
        HEIGHT,
        graphics -> {
          for (Block block : pages.get(number)) {
            Graphics2D translated = (Graphics2D) graphics.create();
            translated.translate(MARGIN, block.top);
            block.content.paint(translated);
            translated.dispose();
          }
          graphics.setFont(Fonts.TICKS);
          graphics.setColor(Palette.GREY);
          String text = "%s, page %s of %s".formatted(footer, number + 1, pages.size());
          graphics.drawString(text, MARGIN, HEIGHT - MARGIN / 2);
        });
  }

  private record Drawn(int height, Painter painter) implements Paintable {
    interface Painter {
      void paint(Graphics2D graphics);
    }

    @Override
    public int width() {
      return WIDTH;
    }

    @Override
    public void paint(Graphics2D graphics) {
      painter.paint(graphics);
    }
  }
}
