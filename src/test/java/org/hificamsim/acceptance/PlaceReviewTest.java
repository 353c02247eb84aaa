package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.Texts;
import org.junit.jupiter.api.Test;

/** Tests {@code place} on plans that exist: it evaluates, compares and keeps them. */
class PlaceReviewTest extends RoomsTest {
  @Test
  void evaluationAgreesWithPlan() throws IOException {
    Path plan = folder.resolve("plan");
    Cli placed = place(site(WALL, DOOR), "--cameras 2 --out " + plan);
    Cli evaluated = Cli.run("place", "--evaluate", plan, "--cells", 12);
    assertEquals(0, evaluated.exit(), evaluated.err());
    String zone = placed.out().lines().filter(line -> line.contains("zone door")).findFirst().get();
    assertTrue(evaluated.out().contains(zone), evaluated.out());
    String price = placed.out().replaceAll("(?s).*price ([0-9.]+):.*", "$1");
    assertTrue(evaluated.out().contains("2 cameras, price " + price + ":"), evaluated.out());
    for (String row : Files.readAllLines(plan.resolve("cameras.csv")).subList(1, 3)) {
      String[] cells = row.split(",");
      double without = 100 * Double.parseDouble(cells[cells.length - 1]);
      String failure = Texts.format("if %s fails: %.2f %%", cells[0], without);
      assertTrue(evaluated.out().contains(failure), failure + evaluated.out());
    }
  }

  @Test
  void writesDocumentsOfEditedPlan() throws IOException {
    Path plan = folder.resolve("plan");
    place(site(WALL, DOOR), "--cameras 2 --out " + plan);
    Path edited = folder.resolve("edited.xml");
    Files.writeString(
        edited,
        Files.readString(plan.resolve("plan.xml")).replaceAll("<camera name=\"P2\".*\n", ""));
    Path out = folder.resolve("documents");
    Cli evaluated =
        Cli.run("place", "--evaluate", edited, "--title", "client=Museum", "--out", out);
    assertEquals(0, evaluated.exit(), evaluated.err());
    String page = Files.readString(out.resolve("index.html"));
    assertTrue(page.contains("1 camera, price ") && page.contains("[\"client\",\"Museum\"]"));
    assertFalse(page.contains("proven") || page.contains("no plan"), page);
    assertEquals(2, Files.readAllLines(out.resolve("order.csv")).size(), "one product");
    assertEquals(2, Files.readAllLines(out.resolve("cameras.csv")).size(), "one camera");
    for (String file : List.of("plan.pdf", "plan.svg", "levels.svg", "plan.dxf", "plan.xml")) {
      assertTrue(Files.size(out.resolve(file)) > 500, file);
    }
    Path whole = folder.resolve("whole");
    Cli.run("place", "--evaluate", plan, "--out", whole);
    assertEquals(
        Files.readString(plan.resolve("order.csv")),
        Files.readString(whole.resolve("order.csv")),
        "the products that were planned, not one for each angle");
    Cli compared = Cli.run("place", "--compare", plan, edited, "--out", out);
    assertEquals(2, compared.exit());
    assertTrue(compared.err().contains("--out writes the documents of one plan"), compared.err());
  }

  @Test
  void comparesEditedPlanWithPlan() throws IOException {
    Path plan = folder.resolve("plan");
    place(site(WALL, DOOR), "--cameras 2 --out " + plan);
    String text = Files.readString(plan.resolve("plan.xml"));
    Path edited = folder.resolve("edited.xml");
    String pillar = "<pillar x=\"3.5\" y=\"3.5\" radius=\"0.6\"/></obstacles>";
    Files.writeString(
        edited, text.replace("</obstacles>", pillar).replaceAll("<camera name=\"P2\".*\n", ""));
    Cli compared = Cli.run("place", "--compare", plan, edited, "--cells", 12);
    assertEquals(0, compared.exit(), compared.err());
    assertTrue(row(compared, "").matches(" +" + plan + "/plan.xml  +" + edited), compared.out());
    assertTrue(row(compared, "cameras").matches("cameras +2 +1"), compared.out());
    String[] met = row(compared, "demand met").split("  +");
    assertTrue(percent(met[1]) > percent(met[2]), compared.out());
    assertTrue(row(compared, "camera P2").endsWith("  -"), compared.out());
    assertFalse(compared.out().contains("camera P1"), "is in both");
    String obstacles = row(compared, "obstacles (not the same)");
    assertTrue(obstacles.matches("obstacles \\(not the same\\) +1 +2"), obstacles);
    Cli same = Cli.run("place", "--compare", plan, plan, "--cells", 12);
    assertFalse(same.out().contains("obstacles"), same.out());
  }

  private static String row(Cli compared, String name) {
    return compared
        .out()
        .lines()
        .filter(line -> line.startsWith(name + "  "))
        .findFirst()
        .orElseThrow(() -> new AssertionError(compared.out()));
  }

  private static double percent(String text) {
    return Double.parseDouble(text.replace(" %", ""));
  }

  @Test
  void documentStatesFacesAndCommand() throws IOException {
    Path site = site("", DOOR.replace("/>", " facing=\"-90\"/>"));
    Path plan = folder.resolve("faces");
    Cli placed =
        Cli.run("place", site, "--cameras", 1, "--title", "client=City Museum", "--out", plan);
    assertEquals(0, placed.exit(), placed.err());
    String page = Files.readString(plan.resolve("index.html"));
    assertTrue(page.contains("; faces that look to 270°, within 30°"));
    assertTrue(page.contains("--title 'client=City Museum'"), page);
  }

  @Test
  void keptCamerasKeepTheirPrice() throws IOException {
    Path plan = folder.resolve("plan");
    place(site("", DOOR), "--cover --out " + plan);
    List<String> cameras = Files.readAllLines(plan.resolve("cameras.csv"));
    Path again = folder.resolve("again");
    Cli kept = place(plan.resolve("plan.xml"), "--cover --keep all --out " + again);
    assertEquals(0, kept.exit(), kept.err());
    assertTrue(kept.out().contains("price 0.00:"), "of new cameras: " + kept.out());
    assertTrue(kept.out().matches("(?s).* of them kept \\(in all [1-9].*"), kept.out());
    assertTrue(kept.out().contains("no plan costs less than 0.00"), kept.out());
    assertEquals(cameras, Files.readAllLines(again.resolve("cameras.csv")));
    Path wrong = folder.resolve("wrong.xml");
    String text = Files.readString(plan.resolve("plan.xml"));
    Files.writeString(wrong, text.replaceAll(" price=\"[0-9.]+\"", " price=\"-1\""));
    assertRejected(wrong, "--cover", "price is '-1', expected a number from 0 to 1e9");
  }

  @Test
  void explainsWhyLevelsAreNotDrawn() throws IOException {
    String second =
        DOOR.replace("door", "shelf").replace("dori-2014:level=identify", "oodpcvs-2025");
    Cli mixed = place(site("", DOOR + second), "--cameras 2 --out " + folder.resolve("mixed"));
    assertEquals(0, mixed.exit(), mixed.err());
    assertTrue(mixed.out().contains("levels are not drawn"), mixed.out());
    assertFalse(Files.exists(folder.resolve("mixed/levels.svg")));
  }

  @Test
  void boundsSharesOfLowerPrices() throws IOException {
    Path plan = folder.resolve("plan");
    place(site(WALL, ""), "--cameras 6 --out " + plan);
    List<String> rows = Files.readAllLines(plan.resolve("curve.csv"));
    assertEquals("cameras,price,share,bound", rows.get(0));
    double[] bounds = rows.stream().skip(1).mapToDouble(row -> cell(row, 3)).toArray();
    double[] shares = rows.stream().skip(1).mapToDouble(row -> cell(row, 2)).toArray();
    assertTrue(bounds[1] < 0.9, "one camera cannot see all: " + bounds[1]);
    for (int i = 1; i < bounds.length; i++) {
      assertTrue(shares[i] <= bounds[i] + 1e-9 && bounds[i - 1] <= bounds[i] + 1e-9, rows.get(i));
    }
  }

  private static double cell(String row, int column) {
    return Double.parseDouble(row.split(",")[column]);
  }
}
