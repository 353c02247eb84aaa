package org.hificamsim.tracks.place;

/**
 * A name by which parts of a drawing can be chosen.
 *
 * @param kind what the name is, such as "layer"
 */
record Label(String kind, String name) {
  static final String LAYER = "layer";
  static final String CLASS = "class";
  static final String COLOUR = "colour";
  static final String GROUP = "id of a group";
  static final String BLOCK = "block";
  static final String PROPERTY = "property";

  /** The id of a single shape; lists of labels leave it out. */
  static final String ID = "id";
}
