package org.hificamsim.agents.choice;

import org.hificamsim.core.policy.NetworkView;

/**
 * Where a flat array keeps its entry for each camera and view: all views of camera 0, then of
 * camera 1, and so on, each with its own number of views.
 */
public final class ViewTable {
  private final int[] offsets;

  public ViewTable(NetworkView network) {
    offsets = new int[network.cameras() + 1];
    for (int camera = 0; camera < network.cameras(); camera++) {
      offsets[camera + 1] = offsets[camera] + network.views(camera);
    }
  }

  /** The number of entries. */
  public int size() {
    return offsets[offsets.length - 1];
  }

  /** The index of the camera's narrowest view; the wider ones follow. */
  public int offset(int camera) {
    return offsets[camera];
  }
}
