package org.hificamsim.acceptance;

import net.jqwik.api.ForAll;
import net.jqwik.api.Property;

/** The same with 13,000 cases, others each time: {@code gradle fuzz}. */
class Fuzz extends FuzzTest {
  @Override
  @Property(tries = 4000)
  void scenarios(@ForAll("brokenScenarios") FuzzCase broken) {
    super.scenarios(broken);
  }

  @Override
  @Property(tries = 2500)
  void models(@ForAll("brokenModels") FuzzCase broken) {
    super.models(broken);
  }

  @Override
  @Property(tries = 1000)
  void measurements(@ForAll("brokenMeasurements") FuzzCase broken) {
    super.measurements(broken);
  }

  @Override
  @Property(tries = 1000)
  void datasets(@ForAll("brokenDatasets") FuzzCase broken) {
    super.datasets(broken);
  }

  @Override
  @Property(tries = 1000)
  void tracks(@ForAll("brokenTracks") FuzzCase broken) {
    super.tracks(broken);
  }

  @Override
  @Property(tries = 2000)
  void recordings(@ForAll("brokenRecordings") FuzzCase broken) {
    super.recordings(broken);
  }

  @Override
  @Property(tries = 1500)
  void commands(@ForAll("brokenCommands") FuzzCase broken) {
    super.commands(broken);
  }
}
