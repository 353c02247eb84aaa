package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.SightLines;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/** The cameras' observations of a world, and all that policies and listeners may know of it. */
final class ObservedNetwork implements OracleView {
  /** Entries for what a worker has found and not counted yet: few enough for a fast cache. */
  private static final int ROOM = 1 << 10;

  private final Cameras cameras;
  private final Targets targets;
  private final SightLines lines;
  private final Visibility visibility;
  private final Sight sight;
  private final int[] detected;
  private final int[] coverage;
  private final boolean phantoms;
  private final Objective objective;
  private final Field field;
  private final Workers workers;
  private final long[][] found; // of each worker
  private final int[][] counts; // of each worker, in the order of the grid
  private final Workers.Share looking = this::look;
  private final Workers.Share adding = this::addUp;
  private final Division division = new Division();
  private Channel channel = Channel.PERFECT;
  private long[] masks = {};
  private long step;

  ObservedNetwork(World world, Visibility visibility, Workers workers) {
    this(world, visibility, workers, new Sight(world, visibility));
  }

  /** Has messages go over the channel of the scenario. */
  void connect(ChannelModel model, long seed) {
    channel = model.isPerfect() ? Channel.PERFECT : new Channel(model, this, seed);
  }

  ObservedNetwork(World world, Visibility visibility, Workers workers, Sight sight) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.lines = world.sightLines();
    this.visibility = visibility;
    this.sight = sight;
    this.detected = new int[cameras.count()];
    this.coverage = new int[targets.count()];
    this.phantoms = visibility.detection().rule().phantoms() > 0;
    this.objective = world.scenario().objective();
    this.field = world.scenario().field();
    this.workers = workers;
    this.found = new long[workers.count()][ROOM + coverage.length + 1];
    this.counts = new int[workers.count()][coverage.length];
  }

  /** Says which step is under way, and takes note of what its events changed. */
  void beginStep(long newStep) {
    step = newStep;
    sight.beginStep(newStep);
  }

  /** Takes note of where the targets are, for the decisions and the observation that follow. */
  void locate() {
    sight.locate();
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
      detected[camera] += looks ? visibility.phantoms(step, camera) : 0;
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
    sight.look(first, end, detected, counts[worker], found[worker]);
  }

  /** Adds up what all workers counted, each worker for some of the targets. */
  private void addUp(int worker) {
    int first = workers.first(worker, sight.grid().count());
    int end = workers.first(worker + 1, sight.grid().count());
    for (int[] count : counts) {
      for (int i = first; i < end; i++) {
        coverage[sight.grid().point(i)] += count[i];
      }
    }
  }

  @Override
  public long step() {
    return step;
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
  public double reach(int camera, int view) {
    return sight.reach(camera, view);
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
  public Obstacles obstacles() {
    return lines.map();
  }

  @Override
  public Body body(double size) {
    return sight.body(size);
  }

  @Override
  public Field field() {
    return field;
  }

  @Override
  public boolean chancesAt(
      int camera, double x, double y, double size, double transmittance, double[] chances) {
    return sight.chancesAt(camera, x, y, size, transmittance, chances);
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
  public double confidence(int camera, int target) {
    int view = cameras.seeing(camera);
    if (!targets.present(target) || view == Cameras.NO_VIEW) {
      return 0;
    }
    double value = sight.value(camera, view, target);
    return DetectionModel.clamp(value * lines.transmittance(camera, target));
  }

  /** What is seen is not hidden: only what lets a part of the light through is asked. */
  @Override
  public double seenConfidence(int camera, int target, double distance) {
    double value = sight.value(camera, cameras.seeing(camera), target, distance);
    double through = lines.partial() ? lines.transmittance(camera, target) : 1;
    return DetectionModel.clamp(value * through);
  }

  @Override
  public boolean detects(int camera, int view, int target) {
    return targets.present(target) && sight.detects(camera, view, target);
  }

  @Override
  public boolean certain() {
    return visibility.detection().certain();
  }

  @Override
  public double chance(int camera, int view, int target) {
    return targets.present(target) ? sight.chance(camera, view, target) : 0;
  }

  @Override
  public int chances(int camera, int view, int[] who, double[] chances) {
    return sight.chances(camera, view, who, chances);
  }

  @Override
  public double targetSize(int target) {
    return targets.size(target);
  }

  @Override
  public void findSeen(SeenPairs pairs) {
    int filled = 0;
    for (int camera = 0; camera < detected.length; camera++) {
      if (cameras.online(camera)) {
        long[] room = pairs.scratch(filled + coverage.length + 1);
        filled = sight.find(camera, cameras.seeing(camera), room, filled);
      }
    }
    sight.add(pairs, filled);
  }

  @Override
  public boolean dominates(int camera, int view, int other) {
    return sight.dominates(camera, view, other);
  }

  @Override
  public void detections(int camera, long[] masks, int words) {
    sight.mark(camera, masks, words);
  }

  @Override
  public void markCoverable(boolean[] coverable) {
    Arrays.fill(coverable, 0, coverage.length, false);
    int words = (coverage.length + Long.SIZE - 1) / Long.SIZE;
    for (int camera = 0; camera < detected.length; camera++) {
      if (cameras.online(camera)) {
        int all = cameras.views(camera) * words;
        masks = masks.length < all ? new long[all] : masks;
        detections(camera, masks, words);
        mark(all, words, coverable);
      }
    }
  }

  private void mark(int all, int words, boolean[] coverable) {
    for (int i = 0; i < all; i++) {
      for (long bits = masks[i]; bits != 0; bits &= bits - 1) {
        coverable[i % words * Long.SIZE + Long.numberOfTrailingZeros(bits)] = true;
      }
    }
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
