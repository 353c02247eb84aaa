/**
 * Feature abstractions f: the share of an image that a target fills, from its size and distance.
 */
package org.hificamsim.hifi.feature;
