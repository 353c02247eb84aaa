/** The share of a target's silhouette that obstacles and nearer targets hide from a camera. */
package org.hificamsim.core.silhouette;
