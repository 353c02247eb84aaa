/**
 * Reads the elements of scenario files and files of tracks into specs, and checks that they fit
 * together.
 */
package org.hificamsim.core.scenario.file;
