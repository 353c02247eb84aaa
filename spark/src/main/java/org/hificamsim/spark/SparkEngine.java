package org.hificamsim.spark;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.EngineSettings;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.RunTask;

/**
 * Computes runs on Apache Spark. Plans are sent as text, so that any executor can compute any run.
 *
 * <p>Spark repeats the runs that a lost executor has not finished. Results come back one by one, so
 * that the journal of the driver is at any time as complete as that of the local engine.
 */
public final class SparkEngine implements RunEngine {
  private SparkMaster master;
  private Catalogue catalogue;

  @Override
  public String name() {
    return "spark";
  }

  @Override
  public void configure(EngineSettings settings) {
    requireSpark();
    master = SparkMaster.of(settings.master());
    master.requireAnswer();
    catalogue = settings.catalogue();
  }

  @Override
  public void run(List<RunPlan> plans, List<RunTask> tasks, Finished finished) throws IOException {
    if (!tasks.isEmpty()) {
      new SparkJob(master, PortableComparison.of(plans, catalogue)).run(tasks, finished);
    }
  }

  private static void requireSpark() {
    try {
      Class.forName("org.apache.spark.SparkContext", false, SparkEngine.class.getClassLoader());
    } catch (ClassNotFoundException e) {
      throw InputException.of(
              "%s: Spark is not on the class path, expected its jars in the folder of this one",
              setting("engine", "spark"))
          .because(e);
    }
  }
}
