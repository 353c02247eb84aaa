/** The stand-in for CamSim's command line. */
package epics.camwin;
