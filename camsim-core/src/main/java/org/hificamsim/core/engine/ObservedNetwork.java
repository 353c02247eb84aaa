package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;

/** The cameras' observations of a world, and all that policies and listeners may know of it. */
final class ObservedNetwork extends Sight {
  private final int[] detected;
  private final int[] coverage;
  private final boolean phantoms;
  private final Objective objective;
  private final Workers workers;
  private final long[][] found; // of each worker
  private final int[][] counts; // of each worker, in the order of the grid
  private final Workers.Share looking = this::look;
  private final Workers.Share adding = this::addUp;
  private final Division division = new Division();
  private Channel channel = Channel.PERFECT;

  ObservedNetwork(World world, Visibility visibility, Workers workers) {
    this(world, visibility, workers, Double.NaN);
  }

  /** Has messages go over the channel of the scenario. */
  void connect(ChannelModel model, long seed) {
    channel = model.isPerfect() ? Channel.PERFECT : new Channel(model, this, seed);
  }

  /**
   * @param side of the cells that cameras look into, metres; NaN where it is to be chosen
   */
  ObservedNetwork(World world, Visibility visibility, Workers workers, double side) {
    super(world, visibility, side);
    this.detected = new int[cameras.count()];
    this.coverage = new int[targets.count()];
    this.phantoms = visibility.detection().rule().phantoms() > 0;
    this.objective = scenario.objective();
    this.workers = workers;
    this.found = new long[workers.count()][coverage.length + 1];
    this.counts = new int[workers.count()][coverage.length];
  }

  /** Every online camera looks at the targets, or has done so. */
  void observe(Cooperation cooperation) {
    if (!cooperation.observe(detected, coverage)) {
      observe();
    }
    if (phantoms) {
      addPhantoms();
    }
  }

  /** What cameras report of targets that are not there covers none that is. */
  private void addPhantoms() {
    for (int camera = 0; camera < detected.length; camera++) {
      boolean looks = cameras.online(camera) && cameras.seeing(camera) != Cameras.NO_VIEW;
      detected[camera] += looks ? visibility.phantoms(step(), camera) : 0;
    }
  }

  /** Every online camera looks at the targets, each at its current view. */
  void observe() {
    workers.run(looking);
    Arrays.fill(coverage, 0);
    workers.run(adding);
  }

  private void look(int worker) {
    Arrays.fill(counts[worker], 0);
    int first = workers.first(worker, detected.length);
    int end = workers.first(worker + 1, detected.length);
    look(first, end, detected, counts[worker], found[worker]);
  }

  /** Adds up what all workers counted, each worker for some of the targets. */
  private void addUp(int worker) {
    int first = workers.first(worker, grid().count());
    int end = workers.first(worker + 1, grid().count());
    for (int[] count : counts) {
      for (int i = first; i < end; i++) {
        coverage[grid().point(i)] += count[i];
      }
    }
  }

  @Override
  public Objective objective() {
    return objective;
  }

  @Override
  public Channel channel() {
    return channel;
  }

  @Override
  public int revision() {
    return cameras.revision();
  }

  @Override
  public int cameras() {
    return cameras.count();
  }

  @Override
  public String cameraName(int camera) {
    return cameras.name(camera);
  }

  @Override
  public boolean online(int camera) {
    return cameras.online(camera);
  }

  @Override
  public double cameraX(int camera) {
    return cameras.x(camera);
  }

  @Override
  public double cameraY(int camera) {
    return cameras.y(camera);
  }

  @Override
  public double cameraHeading(int camera) {
    return cameras.heading(camera);
  }

  @Override
  public int views(int camera) {
    return cameras.views(camera);
  }

  @Override
  public int view(int camera) {
    return cameras.view(camera);
  }

  @Override
  public ZoomLevel zoom(int camera, int view) {
    return cameras.zoom(camera, view);
  }

  @Override
  public int zooms(int camera) {
    return cameras.zooms(camera);
  }

  @Override
  public double pan(int camera, int view) {
    return cameras.pan(camera, view);
  }

  @Override
  public int seeing(int camera) {
    return cameras.seeing(camera);
  }

  @Override
  public boolean moving(int camera) {
    return cameras.moving(camera);
  }

  @Override
  public boolean reaches(int camera, int view) {
    return cameras.reaches(camera, view);
  }

  @Override
  public int stepsTo(int camera, int view) {
    return cameras.stepsTo(camera, view);
  }

  @Override
  public double turnInStep(int camera) {
    return cameras.turnInStep(camera);
  }

  @Override
  public double zoomInStep(int camera) {
    return cameras.zoomInStep(camera);
  }

  @Override
  public int detected(int camera) {
    return detected[camera];
  }

  @Override
  public int targets() {
    return targets.count();
  }

  @Override
  public String targetName(int target) {
    return targets.name(target);
  }

  @Override
  public boolean present(int target) {
    return targets.present(target);
  }

  @Override
  public double targetX(int target) {
    return targets.x(target);
  }

  @Override
  public double targetY(int target) {
    return targets.y(target);
  }

  @Override
  public int coverage(int target) {
    return coverage[target];
  }

  @Override
  public double targetSize(int target) {
    return targets.size(target);
  }

  @Override
  public <T> void divide(T work, CameraTask<T> task) {
    division.run(work, task);
  }

  /** A policy's task, divided among the workers. */
  private final class Division implements Workers.Share {
    private Object work;
    private CameraTask<Object> task;

    @SuppressWarnings("unchecked") // both are of one type, see divide
    <T> void run(T newWork, CameraTask<T> newTask) {
      work = newWork;
      task = (CameraTask<Object>) newTask;
      workers.run(this);
    }

    @Override
    public void run(int worker) {
      int all = cameras.count();
      task.run(
          ObservedNetwork.this, work, workers.first(worker, all), workers.first(worker + 1, all));
    }
  }
}
