/**
 * Detection by pixel density: what standards of video surveillance demand, and target acquisition.
 */
package org.hificamsim.hifi.density;
