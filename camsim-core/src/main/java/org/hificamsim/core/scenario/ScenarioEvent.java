package org.hificamsim.core.scenario;

/** Something that happens at the beginning of a step. */
public sealed interface ScenarioEvent {
  /** The step at whose beginning it fires, from 0. */
  int step();

  /** A camera is added after the existing ones. */
  record AddCamera(int step, CameraSpec camera) implements ScenarioEvent {}

  /**
   * A camera is moved, turned or given another range; -1 leaves a value as it is, as in CamSim.
   *
   * @param heading degrees
   * @param viewingAngle degrees
   */
  record ChangeCamera(
      int step,
      String camera,
      double x,
      double y,
      double heading,
      double viewingAngle,
      double range)
      implements ScenarioEvent {}

  /**
   * A camera goes offline.
   *
   * @param duration steps; any value but 0 means for ever, as in CamSim; 0 does nothing
   */
  record FailCamera(int step, String camera, int duration) implements ScenarioEvent {}

  /** A target appears. */
  record AddTarget(int step, TargetSpec target) implements ScenarioEvent {}

  /** The target with these features disappears; without such a target nothing happens. */
  record RemoveTarget(int step, double features) implements ScenarioEvent {}

  /** The global registration goes offline. */
  record FailRegistration(int step, int duration) implements ScenarioEvent {}
}
