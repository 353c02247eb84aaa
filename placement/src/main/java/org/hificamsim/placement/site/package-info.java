/**
 * Makes a covering problem of a site: what is demanded, where cameras can be, and what they see.
 *
 * <p>A plan is made in this order: {@link org.hificamsim.placement.site.Demand}, {@link
 * org.hificamsim.placement.site.MountPoints}, {@link
 * org.hificamsim.placement.site.PlacementProblem#of}, which makes the candidates and finds what
 * they see, and {@link org.hificamsim.placement.site.PlacementProblem#solve}, which searches for a
 * plan and then refines it.
 */
package org.hificamsim.placement.site;
