package org.hificamsim.presentation.replay;

/** A camera at the start, or where an event will add it. */
public record CameraSetup(String name, CameraPose pose) {}
