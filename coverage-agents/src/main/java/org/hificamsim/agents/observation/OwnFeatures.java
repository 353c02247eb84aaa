package org.hificamsim.agents.observation;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;

/** What a camera knows of itself; what changes only with the network's revision is kept. */
final class OwnFeatures {
  private static final int FIXED = 5; // online, x, y and the mounted heading

  private final Standpoints standpoints;
  private final float[] fixed;
  private final float[][] views; // of each camera: pan, zoom and opening angle of each view
  private int revision;

  OwnFeatures(NetworkView network, Standpoints standpoints) {
    this.standpoints = standpoints;
    fixed = new float[network.cameras() * FIXED];
    views = new float[network.cameras()][];
    note(network);
  }

  void update(NetworkView network) {
    if (network.revision() != revision) {
      note(network);
    }
  }

  private void note(NetworkView network) {
    revision = network.revision();
    for (int camera = 0; camera < views.length; camera++) {
      int at = camera * FIXED;
      fixed[at] = 1;
      fixed[at + 1] = standpoints.x(network.cameraX(camera));
      fixed[at + 2] = standpoints.y(network.cameraY(camera));
      fixed[at + 3] = Bounds.signed(Math.sin(network.cameraHeading(camera)));
      fixed[at + 4] = Bounds.signed(Math.cos(network.cameraHeading(camera)));
      noteViews(network, camera);
    }
  }

  private void noteViews(NetworkView network, int camera) {
    int zooms = network.zooms(camera);
    float[] of = new float[3 * network.views(camera)];
    for (int view = 0; view < network.views(camera); view++) {
      of[3 * view] = Bounds.signed(network.pan(camera, view) / Math.PI);
      of[3 * view + 1] = zooms == 1 ? 1 : Bounds.share(view % zooms / (zooms - 1.0));
      of[3 * view + 2] = Bounds.share(network.zoom(camera, view).viewingAngle() / (2 * Math.PI));
    }
    boolean alike = camera > 0 && Arrays.equals(of, views[camera - 1]);
    views[camera] = alike ? views[camera - 1] : of; // one array for all of a kind stays near
  }

  /**
   * Writes what a camera that is online knows of itself.
   *
   * @param way decisions since it set out
   */
  void write(NetworkView network, int camera, int way, float[] out, int at) {
    System.arraycopy(fixed, camera * FIXED, out, at, FIXED);
    float[] of = views[camera];
    int goal = 3 * network.view(camera);
    out[at + 5] = of[goal];
    out[at + 6] = of[goal + 1];
    int seeing = network.seeing(camera);
    if (seeing >= 0) {
      System.arraycopy(of, 3 * seeing, out, at + 7, 3);
    } else {
      out[at + 10] = 1;
    }
    out[at + 11] = way > 0 ? 1 : 0;
    out[at + 12] = way / (way + 1f);
    out[at + 13] = Bounds.share((double) network.detected(camera) / network.targets());
  }
}
