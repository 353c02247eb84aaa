package org.hificamsim.presentation.replay;

/**
 * The new pose of a camera from a step on.
 *
 * @param camera its number
 */
public record Move(long step, int camera, CameraPose pose) {}
