package org.hificamsim.placement.site;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;

/** Makes sites and their demands for tests. */
final class TestSite {
  private TestSite() {}

  /** Writes a site into a folder, and reads it. */
  static Scenario read(Path folder, String xml) throws IOException {
    Path file = Files.writeString(folder.resolve("site.xml"), xml);
    return ScenarioReader.read(file, movement -> true, warning -> {});
  }

  /** Returns the demand of a site by one detection, without recorded targets. */
  static Demand demand(Scenario site, Sampling sampling, Detection detection) {
    return Demand.of(
        site,
        sampling,
        Optional.empty(),
        new Demand.Detections(detection, name -> detection),
        Optional.empty());
  }
}
