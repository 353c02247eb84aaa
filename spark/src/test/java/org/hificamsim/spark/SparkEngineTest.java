package org.hificamsim.spark;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Optional;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.runs.compare.EngineSettings;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.RunEngineContract;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.TestFactory;

/** Tests Spark in this process, with the master {@code local[2]}. */
class SparkEngineTest {
  @BeforeAll
  static void requireSpark() {
    SparkHome.require();
  }

  @TestFactory
  Stream<DynamicTest> fulfilsContractOfEngines() {
    assertEquals(SparkEngine.class, engine().getClass());
    return new RunEngineContract(SparkEngineTest::engine).tests();
  }

  private static RunEngine engine() {
    RunEngine engine = RunEngine.registry().create("spark");
    engine.configure(new EngineSettings(Catalogue.load(), 1, Optional.of("local[2]")));
    return engine;
  }
}
