/** What share of a target's silhouette obstacles and nearer targets hide from a camera. */
package org.hificamsim.core.silhouette;
