/** Scenario files: CamSim's XML and the coverage study's dialect, read, checked and written. */
package org.hificamsim.core.scenario;
