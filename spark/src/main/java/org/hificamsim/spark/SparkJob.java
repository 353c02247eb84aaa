package org.hificamsim.spark;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.File;
import java.io.IOException;
import java.net.URISyntaxException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.FutureTask;
import java.util.concurrent.TimeUnit;
import java.util.concurrent.TimeoutException;
import java.util.regex.Pattern;
import org.apache.spark.SparkConf;
import org.apache.spark.SparkContext;
import org.apache.spark.api.java.JavaSparkContext;
import org.apache.spark.broadcast.Broadcast;
import org.apache.spark.rdd.RDD;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.RunTask;
import scala.reflect.ClassTag$;

/**
 * A comparison as one Spark job. Every run is a task of its own, up to the number of tasks that
 * Spark can handle.
 */
final class SparkJob {
  private static final int MAX_PARTITIONS = 10_000;
  private static final int TIMEOUT_SECONDS = 30;

  private final SparkMaster master;
  private final PortableComparison comparison;

  SparkJob(SparkMaster master, PortableComparison comparison) {
    this.master = master;
    this.comparison = comparison;
  }

  /** Computes the tasks and passes each result to {@code finished} when it arrives. */
  void run(List<RunTask> tasks, RunEngine.Finished finished) throws IOException {
    SparkConf conf = conf();
    try (ClassPathJars jars =
        new ClassPathJars(sendsJars(conf) ? classPath() : List.of(), sparkJars())) {
      if (sendsJars(conf)) {
        conf.setJars(jars.paths().toArray(new String[0]));
      }
      try (JavaSparkContext context = connect(conf)) {
        compute(context, tasks, finished);
      }
    }
  }

  private void compute(JavaSparkContext context, List<RunTask> tasks, RunEngine.Finished finished)
      throws IOException {
    RDD<RunTask> partitions =
        context.parallelize(tasks, Math.min(tasks.size(), MAX_PARTITIONS)).rdd();
    Broadcast<PortableComparison> shared = context.broadcast(comparison);
    AnswerCollector collector = new AnswerCollector(finished);
    try {
      context
          .sc()
          .runJob(
              partitions,
              new RunPartition(shared),
              collector,
              ClassTag$.MODULE$.<Answer[]>apply(Answer[].class));
    } finally {
      if (collector.isFaulty()) {
        context.setLogLevel("OFF"); // hides messages about dropped tasks
      }
      collector.check();
    }
  }

  private SparkConf conf() {
    return new SparkConf()
        .setMaster(master.url())
        .setIfMissing("spark.app.name", "hificamsim")
        .setIfMissing("spark.ui.enabled", "false")
        .setIfMissing("spark.driver.maxResultSize", "0") // results are not kept on the driver
        .set("spark.serializer", "org.apache.spark.serializer.JavaSerializer");
  }

  /** Whether the jars have to be sent from here; {@code spark-submit} sends them itself. */
  private boolean sendsJars(SparkConf conf) {
    return !master.isLocal() && !conf.contains("spark.submit.deployMode");
  }

  private static List<Path> classPath() {
    return Pattern.compile(File.pathSeparator, Pattern.LITERAL)
        .splitAsStream(System.getProperty("java.class.path"))
        .filter(entry -> !entry.isEmpty())
        .map(Path::of)
        .toList();
  }

  /** The folder of Spark's jars. */
  private static Path sparkJars() {
    try {
      return Path.of(SparkContext.class.getProtectionDomain().getCodeSource().getLocation().toURI())
          .getParent();
    } catch (URISyntaxException e) {
      throw new IllegalStateException(e);
    }
  }

  /** Connects with a timeout; without it Spark would try for a minute and print a stack trace. */
  private JavaSparkContext connect(SparkConf conf) throws IOException {
    FutureTask<JavaSparkContext> connecting = new FutureTask<>(() -> new JavaSparkContext(conf));
    Thread thread = new Thread(connecting, "spark-connect");
    thread.setDaemon(true);
    thread.start();
    try {
      return connecting.get(TIMEOUT_SECONDS, TimeUnit.SECONDS);
    } catch (TimeoutException e) {
      throw InputException.of(
              "%s '%s' has not taken the job within %s s, expected the URL of a Spark" + " master",
              setting("master"), master.url(), TIMEOUT_SECONDS)
          .because(e);
    } catch (ExecutionException e) {
      throw InputException.of(
              "%s '%s': Spark does not start (%s)", setting("master"), master.url(), e.getCause())
          .because(e);
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    }
  }
}
