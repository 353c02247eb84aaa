package org.hificamsim.presentation.replay;

/**
 * A camera that stands, looks or sees otherwise from a step on.
 *
 * @param camera its number
 */
public record Move(long step, int camera, CameraPose pose) {}
