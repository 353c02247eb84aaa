package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests claims of {@code place --evaluate} about shipped sites by putting people into zones. */
class SiteClaimTest {
  private static final double TOLERANCE = 1;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "border", "campus", "campus-heights", "car-park", "corridor", "hall", "hit-mac",
        "junction", "mate-4v8-9", "museum", "passage", "street", "warehouse", "warehouse-heights"
      })
  void claimHoldsOnShippedSites(String name) {
    Path site = Cli.ROOT.resolve("scenarios").resolve(name + ".xml");
    Cli evaluated = Cli.run("place", "--evaluate", site);
    assertEquals(0, evaluated.exit(), evaluated.err());
    Scenario read = ScenarioReader.read(site, movement -> true, warning -> {});
    String usual = Settings.NONE.value(Setting.DETECTION, read);
    List<Zone> zones = Zone.ofSite(read.zones());
    for (Zone zone : zones) {
      double claim = ZoneRaster.claims(evaluated.out()).get(zone.name());
      assertEquals(100 * ZoneRaster.share(read, zone, usual), claim, TOLERANCE, zone.name());
    }
  }
}
