/** Adds hi-fi detection, zoom policies and k-coverage to an unmodified CamSim. */
package org.hificamsim.bridge;
