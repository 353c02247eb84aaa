package org.hificamsim.catalogue;

import java.io.File;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import org.hificamsim.agents.CoveragePolicies;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.GeometricDetection;
import org.hificamsim.core.detection.camsim.CamSimDetections;
import org.hificamsim.core.engine.NetworkModel;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.policy.OraclePolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.world.Movement;
import org.hificamsim.core.world.movement.Movements;
import org.hificamsim.hifi.density.DensityDetections;
import org.hificamsim.hifi.model.BoxDetections;
import org.hificamsim.hifi.model.HiFiDetections;
import org.hificamsim.hifi.model.LabDetections;
import org.hificamsim.hifi.model.ModelFiles;

/**
 * Finds everything that has a name: the parts that come with the simulator, and those in users'
 * jars on the class path.
 */
public record Catalogue(
    Registry<DetectionModel> detections,
    Registry<ZoomPolicy> policies,
    Registry<Movement> movements,
    Registry<StepListener> listeners,
    Registry<NetworkModel> networks) {
  /** Returns the catalogue of the class path. */
  public static Catalogue load() {
    Registry<DetectionModel> detections = new Registry<>("detection");
    CamSimDetections.register(detections);
    detections.register(
        "geometric", "certain inside the field of view: upper bound", GeometricDetection::new);
    DensityDetections.register(detections);
    detections.registerWhenNeeded(HiFiDetections::register);
    detections.registerWhenNeeded(LabDetections::register);
    detections.registerWhenNeeded(BoxDetections::register);
    detections.registerWhenNeeded(Catalogue::registerServices);
    Registry<ZoomPolicy> policies = CoveragePolicies.register(new Registry<>("policy"));
    policies.registerServices(ZoomPolicy.class, ZoomPolicy::name, ZoomPolicy::configure);
    Registry<StepListener> listeners = new Registry<>("listener");
    listeners.registerServices(StepListener.class, StepListener::name, (listener, options) -> {});
    Registry<NetworkModel> networks = new Registry<>("network");
    networks.registerServices(NetworkModel.class, NetworkModel::name, NetworkModel::configure);
    return new Catalogue(detections, policies, Movements.registry(), listeners, networks);
  }

  private static void registerServices(Registry<DetectionModel> detections) {
    detections.registerServices(DetectionModel.class, DetectionModel::name, (model, options) -> {});
  }

  /**
   * Returns the detection model of a name or a model file.
   *
   * @throws org.hificamsim.core.InputException when there is no such model or file, or the file is
   *     wrong
   */
  public DetectionModel detection(String nameOrFile) {
    boolean isFile =
        nameOrFile.endsWith(".json")
            || (!detections.knows(nameOrFile) && new File(nameOrFile).isFile());
    return isFile ? ModelFiles.read(path(nameOrFile)) : detections.create(nameOrFile);
  }

  /**
   * Whether a policy is a bound, which knows what no camera can know.
   *
   * @param policy the name of a policy, with or without options
   */
  public boolean isBound(String policy) {
    return policies.create(policy) instanceof OraclePolicy;
  }

  private static Path path(String file) {
    try {
      return Path.of(file);
    } catch (InvalidPathException e) {
      throw new InputException(
          "'%s' is no file's name (%s), expected a model in JSON".formatted(file, e.getReason()),
          e);
    }
  }
}
