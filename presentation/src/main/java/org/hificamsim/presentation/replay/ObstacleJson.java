package org.hificamsim.presentation.replay;

import com.fasterxml.jackson.annotation.JsonSubTypes;
import com.fasterxml.jackson.annotation.JsonTypeInfo;
import org.hificamsim.core.obstacle.Obstacle;

/** How an {@link Obstacle} is told from others in JSON: by the name of its element in scenarios. */
@JsonTypeInfo(use = JsonTypeInfo.Id.NAME, property = "kind")
@JsonSubTypes({
  @JsonSubTypes.Type(value = Obstacle.Wall.class, name = "wall"),
  @JsonSubTypes.Type(value = Obstacle.Polygon.class, name = "polygon"),
  @JsonSubTypes.Type(value = Obstacle.Pillar.class, name = "pillar")
})
interface ObstacleJson {}
