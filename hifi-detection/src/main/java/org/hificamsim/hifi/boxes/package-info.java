/** Detectors that draw boxes: how surely a person is found, by pixel height and hidden share. */
package org.hificamsim.hifi.boxes;
