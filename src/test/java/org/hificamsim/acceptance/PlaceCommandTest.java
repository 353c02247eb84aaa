package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;

/** Tests {@code place}: plans, their verification, instances, and errors. */
class PlaceCommandTest extends RoomsTest {
  @Test
  void makesPlansThatRunAndPassVerification() throws IOException {
    Path site = site(WALL, DOOR + "<zone name=\"all\" shape=\"field\"/>");
    for (String words :
        new String[] {
          "--cameras 3 --catalogue site",
          "--budget 900 --keep A --reading any",
          "--cameras 2 --catalogue site --demand tracks --redundancy 1",
          "--cover --catalogue site --reading any"
        }) {
      Path plan = folder.resolve("plan");
      Cli placed = place(site, words + " --write-candidates --out " + plan);
      assertEquals(0, placed.exit(), placed.err());
      assertTrue(
          placed.out().matches("(?s).*no plan (of these candidates meets more|costs less) than .*"),
          placed.out());
      Cli checked = Cli.run("place", "--verify", plan);
      assertEquals(0, checked.exit(), words + checked.err());
      assertTrue(checked.out().contains("holds"), checked.out());
      Cli run = Cli.run("run", plan.resolve("plan.xml"), "--out", folder.resolve("run"));
      assertEquals(0, run.exit(), run.err());
    }
  }

  @Test
  void writesAllCandidatesOnlyOnRequest() throws IOException {
    Path plan = folder.resolve("plan");
    String words = "--cameras 2 --out " + plan;
    Path site = site(WALL, DOOR);
    assertEquals(0, place(site, words + " --write-candidates").exit());
    assertTrue(Files.exists(plan.resolve("candidates.xml")));
    assertEquals(0, place(site, words).exit());
    assertFalse(Files.exists(plan.resolve("candidates.xml")), "from the command before");
    Cli checked = Cli.run("place", "--verify", plan);
    assertEquals(0, checked.exit(), checked.err());
    assertTrue(checked.out().contains("the bound is not checked"), checked.out());
    assertRejectedAfterEdit(plan, "summary.json", "\"share\" : ", "\"share\" : 2", "share is");
  }

  @Test
  void candidatesAreSpreadOverSiteIfTimeIsShort() throws IOException {
    Path plan = folder.resolve("plan");
    String words =
        " --cameras 2 --candidates every=1 --threads 1 --time 0.001 --write-candidates --out ";
    Cli placed = Cli.run((Object[]) ("place " + site("", "") + words + plan).split(" "));
    assertEquals(0, placed.exit(), placed.err());
    assertTrue(placed.out().contains("cameras looked from 8 of "), placed.out());
    Cli checked = Cli.run("place", "--verify", plan);
    assertEquals(0, checked.exit(), checked.err());
    assertTrue(checked.out().contains("holds"), checked.out());
    double[] xs =
        Files.readAllLines(plan.resolve("candidates.xml")).stream()
            .filter(line -> line.contains("<camera "))
            .mapToDouble(line -> Double.parseDouble(line.replaceAll(".* x=\"([^\"]+)\".*", "$1")))
            .toArray();
    assertTrue(DoubleStream.of(xs).min().orElseThrow() < 4, Arrays.toString(xs));
    assertTrue(DoubleStream.of(xs).max().orElseThrow() > 16, Arrays.toString(xs));
  }

  @Test
  void writesDxfThatReadsBack() throws IOException {
    Path plan = folder.resolve("plan");
    Cli placed = place(site(WALL, DOOR), "--cameras 2 --keep A --out " + plan);
    assertEquals(0, placed.exit(), placed.err());
    Path dxf = plan.resolve("plan.dxf");
    Cli layers = Cli.run("site", dxf, "--list-layers");
    assertEquals(0, layers.exit(), layers.err());
    assertTrue(layers.out().contains("  block CAMERA: 6\n"), "a circle and a line, three times");
    assertTrue(layers.out().contains("  layer WALLS: 1\n"), layers::out);
    assertTrue(layers.out().contains("  layer ZONES: 1\n"), layers::out);
    assertTrue(layers.out().contains("  layer SECTORS: 3\n"), layers::out);
    Path back = folder.resolve("back");
    assertEquals(0, Cli.run("site", dxf, "--layers", "WALLS,CAMERAS", "--out", back).exit());
    String xml = Files.readString(back.resolve("plan.xml"));
    assertTrue(xml.contains("<wall x1=\"10.0\" y1=\"0.0\" x2=\"10.0\" y2=\"20.0\"/>"), xml);
    assertTrue(xml.contains("<pillar x=\"1.0\" y=\"1.0\" radius=\"0.2\"/>"), "camera A: " + xml);
    assertTrue(xml.contains("<wall x1=\"1.0\" y1=\"1.0\" x2=\"1.354\" y2=\"1.354\"/>"), xml);
    String text = Files.readString(dxf);
    assertTrue(text.contains("\n45.00\n2\nHEADING\n"), "the attributes of camera A");
  }

  @Test
  void mountsAndTiltsNewCamerasOnSitesWithHeights() throws IOException {
    Path site = site(WALL.replace("/>", " height=\"1.2\"/>"), "");
    Path plan = folder.resolve("plan");
    Cli placed = place(site, "--cameras 3 --reading fixed --out " + plan);
    assertEquals(0, placed.exit(), placed.err());
    String planned = Files.readString(plan.resolve("plan.xml"));
    assertEquals(3, planned.split("z=\"3.0\"", -1).length - 1, planned);
    assertTrue(planned.contains("tilt=\"15.0\""), planned);
    assertEquals(0, Cli.run("place", "--verify", plan).exit());
    Path mounted = folder.resolve("mounted.xml");
    String text = Files.readString(site);
    Files.writeString(mounted, text.replace("steps=", "mount_height=\"4\" steps="));
    place(mounted, "--cameras 1 --out " + folder.resolve("at"));
    assertFalse(Files.readString(folder.resolve("at/plan.xml")).contains(" z="));
  }

  @Test
  void makesPlansOfLensesOfSiteThatPassVerification() throws IOException {
    for (String words :
        new String[] {
          "mate-4v8-9 --reading fixed", "warehouse-heights", "warehouse-heights --reading any"
        }) {
      String site = words.split(" ")[0];
      Path spots = folder.resolve(site + ".csv");
      Path plan = folder.resolve(words.replace(' ', '-'));
      Files.writeString(spots, "x,y\n40,20\n79,49\n");
      String rest = words.substring(site.length()) + " --candidates " + spots + " --out " + plan;
      Cli placed =
          Cli.run(
              (Object[])
                  ("place " + Cli.scenario(site) + " --cameras 2 --cells 12 --catalogue site")
                      .concat(rest)
                      .split(" "));
      assertEquals(0, placed.exit(), placed.err());
      Cli checked = Cli.run("place", "--verify", plan);
      assertEquals(0, checked.exit(), words + checked.err());
    }
  }

  @Test
  void runAndCompareMeasureZonesAsPlaceDoes() throws IOException {
    Path site = site(WALL, DOOR + "<zone name=\"all\" shape=\"field\" weight=\"0.5\"/>");
    Path plan = folder.resolve("plan");
    Cli.run(
        (Object[])
            ("place " + site + " --cameras 1 --catalogue site --candidates every=9 --out " + plan)
                .split(" "));
    String share = value(plan.resolve("summary.json"), "share_of_site");
    Path run = folder.resolve("run");
    Cli ran = Cli.run("run", site, "--policy", "fixed:1,0", "--repeat", 2, "--out", run);
    assertTrue(ran.out().contains("zones met"), ran.out() + ran.err());
    Path summary = run.resolve("summary.json");
    double met = Double.parseDouble(value(summary, "zones_met"));
    assertEquals(Double.parseDouble(share), met, 0.002);
    assertEquals(0.2355, Double.parseDouble(value(summary, "least_zone_met")), 0.01);
    Path compared = folder.resolve("compared");
    Cli.run("compare", site, "--policies", "fixed,zoom-out", "--repeat", 2, "--out", compared);
    assertTrue(Files.readString(compared.resolve("metrics.csv")).contains(",zones_met,"));
    Cli plain = Cli.run("run", site("", ""), "--policy", "fixed", "--out", folder.resolve("none"));
    assertFalse(plain.out().contains("zones met"), plain.out());
  }

  @Test
  void sameSeedGivesTheSamePlan() throws IOException {
    Path site = site("", "");
    place(site, "--cameras 3 --seed 4 --out " + folder.resolve("a"));
    place(site, "--cameras 3 --seed 4 --out " + folder.resolve("b"));
    for (String file : new String[] {"plan.xml", "summary.json", "samples.csv", "curve.csv"}) {
      assertEquals(
          -1L,
          Files.mismatch(folder.resolve("a").resolve(file), folder.resolve("b").resolve(file)));
    }
  }

  @Test
  void verificationRejectsChangedFiles() throws IOException {
    Path plan = folder.resolve("plan");
    place(site(WALL, ""), "--cameras 3 --write-candidates --out " + plan);
    assertRejectedAfterEdit(
        plan, "plan.xml", "heading=\"", "heading=\"1", "as a run|cover it in a run|expected");
    assertRejectedAfterEdit(plan, "summary.json", "\"share\" : ", "\"share\" : 2", "share is");
    assertRejectedAfterEdit(
        plan, "summary.json", "\"bound\" : ", "\"bound\" : 0.0, \"x\" : ", "bound is");
    assertRejectedAfterEdit(plan, "samples.csv", "field,", "wood,", "zone is 'wood'");
  }

  /**
   * The zone spans 37 degrees around a heading of 52.5 and is too far away for the wide lens. The
   * narrow lens, 40 degrees wide, misses a part of it at the candidates' headings of 45 and 60.
   */
  @Test
  void refinementFindsHeadingsBetweenCandidates() throws IOException {
    Path site =
        site(
            "",
            "<zone name=\"far\" shape=\"polygon\" points=\"6.03,8.46 9.95,14.26 16.13,6.21"
                + " 9.51,3.93\"/>");
    Path spot = Files.writeString(folder.resolve("spot.csv"), "x,y\n1,1\n");
    Path plan = folder.resolve("plan");
    String words = "--cameras 1 --catalogue site --seed 2 --candidates " + spot + " --out ";
    String cells = " --cells 60";
    Cli placed = refined(site, words + folder.resolve("plain") + cells);
    assertEquals(0, placed.exit(), placed.err());
    assertFalse(Files.readString(folder.resolve("plain/summary.json")).contains("unrefined"));
    placed = refined(site, words + plan + cells + " --refine --threads 2 --write-candidates");
    assertTrue(placed.out().contains("refined from a plan of candidates"), placed.out());
    refined(site, words + folder.resolve("again") + cells + " --refine --threads 1");
    assertEquals(-1L, Files.mismatch(plan.resolve("plan.xml"), folder.resolve("again/plan.xml")));
    Path summary = plan.resolve("summary.json");
    double share = Double.parseDouble(value(summary, "share"));
    double before = Double.parseDouble(value(summary, "share_unrefined"));
    assertEquals(
        before, Double.parseDouble(value(folder.resolve("plain/summary.json"), "share")), 1e-12);
    assertEquals(1, share, 1e-12);
    assertTrue(before < 0.95, "before: " + before);
    assertTrue(Files.readString(plan.resolve("plan.xml")).contains("heading=\"52.5\""));
    assertEquals(share - before, Double.parseDouble(value(summary, "gain_of_refinement")), 1e-12);
    assertTrue(before <= Double.parseDouble(value(summary, "share_bound")) + 1e-12);
    Cli checked = Cli.run("place", "--verify", plan);
    assertEquals(0, checked.exit(), checked.err());
    assertTrue(checked.out().contains("holds"), checked.out());
    assertRejectedAfterEdit(
        plan, "plan.xml", "heading=\"", "heading=\"1", "cover it in a run|expected");
    assertRejectedAfterEdit(
        plan, "summary.json", "\"share_unrefined\" : 0", "\"share_unrefined\" : 1", "is 1");
    assertRejectedAfterEdit(
        plan, "summary.json", "\"unrefined\" : [", "\"unrefined\" : [ 99999, ", "lens of");
    assertRejectedAfterEdit(plan, "summary.json", "\"unrefined\"", "\"un\"", "score is");
    assertRejectedAfterEdit(
        plan, "summary.json", "\"bound\" : ", "\"bound\" : 0.0, \"x\" : ", "bound is");
  }

  @Test
  void refinementRespectsKeptCamerasAndForbiddenZones() throws IOException {
    Path site = site(WALL, DOOR + "<zone name=\"low\" points=\"0,0 20,3\"/>");
    Path plan = folder.resolve("plan");
    for (String words :
        new String[] {
          "--cameras 2 --keep A", "--budget 900 --reading any", "--cameras 1 --time 0"
        }) {
      String more = " --refine --forbid low --catalogue generic --out " + plan;
      Cli placed = place(site, words + more);
      assertEquals(0, placed.exit(), placed.err());
      assertTrue(
          Double.parseDouble(value(plan.resolve("summary.json"), "gain_of_refinement")) >= 0);
      for (String row : Files.readAllLines(plan.resolve("cameras.csv"))) {
        if (row.startsWith("P")) {
          assertTrue(Double.parseDouble(row.split(",")[2]) > 3, row);
        }
        assertTrue(!row.startsWith("A,") || row.startsWith("A,1.0,1.0,45.0"), row);
      }
      assertEquals(0, Cli.run("place", "--verify", plan).exit(), words);
    }
  }

  private static Cli refined(Path site, String words) {
    return Cli.run((Object[]) ("place " + site + " " + words).split(" "));
  }

  private void assertRejectedAfterEdit(
      Path plan, String file, String old, String broken, String message) throws IOException {
    Path path = plan.resolve(file);
    String text = Files.readString(path);
    assertTrue(text.contains(old), file);
    Files.writeString(path, text.replace(old, broken));
    Cli checked = Cli.run("place", "--verify", plan);
    assertEquals(2, checked.exit(), file + checked.out());
    assertTrue(checked.err().matches("(?s).*(" + message + ").*"), checked.err());
    assertEquals(1, checked.err().lines().count());
    Files.writeString(path, text);
  }

  @Test
  void solvesAndWritesInstancesInBothForms() throws IOException {
    Path scp = Files.writeString(folder.resolve("scp.txt"), "3 4\n1 1 1 3\n2 1 4\n2 2 4\n2\n3 4\n");
    Cli solved = Cli.run("place", "--instance", scp);
    assertEquals(0, solved.exit(), solved.err());
    assertTrue(
        solved.out().contains("proven of 3 samples and 4 candidates: no plan of these is better"),
        solved.out());
    assertTrue(solved.out().contains("score 3.00, bound 3.00, gap 0.000 %"), solved.out());
    Path plan = folder.resolve("plan");
    for (String form : new String[] {"scp", "candidates"}) {
      place(site(WALL, ""), "--cover --catalogue site --form " + form + " --out " + plan);
      Cli solvedAgain =
          Cli.run("place", "--instance", plan.resolve("instance.txt"), "--form", form);
      assertTrue(
          Files.readString(plan.resolve("summary.json"))
              .matches("(?s).*\"proven_of\" : \"[0-9]+ samples and [0-9]+ candidates? at .*"));
      String price = "\"price\" : " + solvedAgain.out().replaceAll("(?s).*price ([0-9]+).*", "$1");
      assertTrue(Files.readString(plan.resolve("summary.json")).contains(price), solvedAgain.out());
    }
  }

  @Test
  void reportsEachErrorInOneLine() throws IOException {
    Path plain = site("", "");
    assertRejected(plain, "", "expected one of --cameras N, --budget EUR and --cover");
    assertRejected(plain, "--cameras 0", "--cameras is 0");
    assertRejected(plain, "--evaluate " + plain, "expected no site, instance or goal");
    assertRejected(Path.of("--evaluate"), plain + " --cover", "expected no site, instance or goal");
    assertRejected(Path.of("--compare"), plain + " " + folder.resolve("none.xml"), "none.xml");
    assertRejected(
        plain, "--cover --refine", "--refine is for a site with --cameras N or --budget EUR");
    assertRejected(plain, "--budget 2", "the price of the cheapest camera");
    assertRejected(plain, "--cameras 1 --keep C", "no camera 'C'");
    assertRejected(plain, "--cameras 1 --forbid yard", "no zone 'yard'");
    Path table =
        Files.writeString(folder.resolve("c.csv"), "name,resolution,hfov,price\na,1920,60,dear\n");
    assertRejected(plain, "--cameras 1 --catalogue " + table, "c.csv:2:11: price is 'dear'");
    Path far = site(WALL, DOOR);
    Files.writeString(folder.resolve("p.csv"), "x,y\n15,15\n");
    assertRejected(
        far,
        "--cameras 1 --candidates " + folder.resolve("p.csv"),
        "zone 'door' is seen from none of 1 places: walls are in between");
    Path low = site(WALL, DOOR.replace("1,1 6,6", "14.6,14.6 15.4,15.4"));
    String text = Files.readString(low);
    Files.writeString(low, text.replace("<camera name=\"A\"", "<camera name=\"A\" z=\"9\""));
    assertRejected(
        low,
        "--cameras 1 --candidates " + folder.resolve("p.csv"),
        "zone 'door' is seen from none of 1 places: it is above or below all views");
    assertRejected(site("", DOOR.replace("identify", "identify@2")), "--cameras 1", "threshold");
    assertRejected(site("", DOOR.replace("6,6", "60,6")), "--cameras 1", "rooms.xml:");
    assertRejected(site("", DOOR + DOOR), "--cameras 1", "a name that no other zone has");
    Path broken = Files.writeString(folder.resolve("scp.txt"), "3 4\n1 1 1 3\n2 1 9\n");
    Cli refused = Cli.run("place", "--instance", broken);
    assertTrue(refused.err().contains("scp.txt:3:5: '9', expected a candidate"), refused.err());
  }
}
