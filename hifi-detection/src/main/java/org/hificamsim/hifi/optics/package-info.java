/** The camera's optics: angle of view, field-of-view radius and focal length (Eqs 3.1, 3.2). */
package org.hificamsim.hifi.optics;
