/** Writes plans as tables, pages and pictures, and checks that what such files say is true. */
package org.hificamsim.placement.output;
