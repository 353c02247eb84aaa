package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.junit.jupiter.api.io.TempDir;

/** The base of tests of {@code place} on a site of two rooms. */
abstract class RoomsTest {
  static final String WALL = "<wall x1=\"10\" y1=\"0\" x2=\"10\" y2=\"20\"/>";
  static final String DOOR =
      "<zone name=\"door\" points=\"1,1 6,6\" detection=\"dori-2014:level=identify\" k=\"2\"/>";

  @TempDir Path folder;

  /** Writes a site of two rooms, each with a camera of its own kind. */
  Path site(String walls, String zones) throws IOException {
    return Files.writeString(
        folder.resolve("rooms.xml"),
        """
        <root>
          <simulation min_x="0" max_x="20" min_y="0" max_y="20" order="coverage"
              detection="dori-2014:level=recognise" steps="5">
            <obstacles>%s</obstacles>
            <zones>%s</zones>
            <cameras>
              <optics name="wide" hfov="90 40" pixels="1920"/>
              <optics name="turns" hfov="40" pixels="1920" pan="-60:60:30"/>
              <camera name="A" x="1" y="1" heading="45" optics="wide"/>
              <camera name="B" x="19" y="19" heading="225" optics="turns"/>
            </cameras>
            <objects><object x="5" y="5" heading="0" speed="1" features="1"/></objects>
          </simulation>
        </root>
        """
            .formatted(walls, zones));
  }

  Cli place(Path site, String words) {
    return Cli.run(
        (Object[])
            ("place " + site + " --cells 12 --candidates every=4 --threads 1 " + words).split(" "));
  }

  static String value(Path json, String name) throws IOException {
    return Files.readString(json).replaceAll("(?s).*?\"" + name + "\" : ([-0-9.E]+).*", "$1");
  }

  static void assertRejected(Path site, String words, String message) {
    Cli refused = Cli.run((Object[]) ("place " + site + " " + words).strip().split(" "));
    assertEquals(2, refused.exit(), refused.out());
    assertTrue(refused.err().contains(message), refused.err());
    assertFalse(refused.err().strip().contains("\n"), refused.err());
  }
}
