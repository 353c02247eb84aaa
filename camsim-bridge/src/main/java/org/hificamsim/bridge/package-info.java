/** Hi-fi detection, zoom policies and k-coverage inside an unmodified CamSim. */
package org.hificamsim.bridge;
