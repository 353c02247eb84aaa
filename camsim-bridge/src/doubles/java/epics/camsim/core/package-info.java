/**
 * Stand-ins for the classes of CamSim that the bridge changes and calls. They follow this project's
 * description of CamSim's behaviour, as far as active schedules and broadcasts go, and hold none of
 * its code.
 */
package epics.camsim.core;
