/** CamSim's own files: parameters, the table of steps, the summary. */
package org.hificamsim.network.files;
