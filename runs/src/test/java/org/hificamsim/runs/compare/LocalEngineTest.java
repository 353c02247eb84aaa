package org.hificamsim.runs.compare;

import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

class LocalEngineTest {
  @TestFactory
  Stream<DynamicTest> fulfilsContractOfEngines() {
    return new RunEngineContract(LocalEngineTest::engine).tests();
  }

  private static RunEngine engine() {
    RunEngine engine = RunEngine.registry().create("local");
    engine.configure(new EngineSettings(Catalogue.load(), 2, Optional.empty()));
    return engine;
  }
}
