/** Heat maps: what is covered of a field, cell by cell, and where targets were. */
package org.hificamsim.runs.heat;
