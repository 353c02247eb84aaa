package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.policy.OracleView;

/**
 * The distances that the cameras of a run have turned and zoomed, and the changes of their views,
 * all of which wear their motors. A camera's first view does not count as a move; cameras may join
 * later.
 */
public final class CameraMoves {
  private int[] views = {};
  private boolean[] moving = {};
  private double[] pans = {};
  private double[] zooms = {};
  private long cameraSteps;
  private long viewChanges;
  private double panTravel;
  private double zoomTravel;

  /** Adds a step of the network. */
  void add(OracleView network) {
    int known = views.length;
    if (network.cameras() > known) {
      grow(network.cameras());
    }
    for (int camera = 0; camera < network.cameras(); camera++) {
      cameraSteps += network.online(camera) ? 1 : 0;
      if (camera >= known) {
        locate(network, camera);
      } else if (moving[camera] || network.view(camera) != views[camera]) {
        addMove(network, camera);
      }
    }
  }

  private void grow(int cameras) {
    views = Arrays.copyOf(views, cameras);
    moving = Arrays.copyOf(moving, cameras);
    pans = Arrays.copyOf(pans, cameras);
    zooms = Arrays.copyOf(zooms, cameras);
  }

  private void addMove(OracleView network, int camera) {
    viewChanges += network.view(camera) != views[camera] ? 1 : 0;
    double panBefore = pans[camera];
    double zoomBefore = zooms[camera];
    locate(network, camera);
    panTravel += Math.abs(pans[camera] - panBefore);
    zoomTravel += Math.abs(zooms[camera] - zoomBefore);
  }

  private void locate(OracleView network, int camera) {
    views[camera] = network.view(camera);
    moving[camera] = network.moving(camera);
    pans[camera] = network.presentPan(camera);
    zooms[camera] = network.presentZoom(camera);
  }

  /** The number of times that a camera's view differed from that of the step before. */
  public long viewChanges() {
    return viewChanges;
  }

  /** The number of changes of view for each camera and step; 0 without steps. */
  public double viewChangeRate() {
    return perCameraAndStep((double) viewChanges);
  }

  /**
   * Returns the mean angle by which a camera turns in a step, in degrees in either direction; 0
   * without steps.
   */
  public double meanPanTravel() {
    return perCameraAndStep(Math.toDegrees(panTravel));
  }

  /**
   * Returns the mean change of a lens in a step, in zoom levels in either direction; 0 without
   * steps.
   */
  public double meanZoomTravel() {
    return perCameraAndStep(zoomTravel);
  }

  private double perCameraAndStep(double sum) {
    return cameraSteps == 0 ? 0 : sum / cameraSteps;
  }
}
