package badlog.bag

import badlog.recording.Value

/**
 * What line 1 of a bag says: its topics and its values. Unknown keys of the object itself, of a topic and of a value are
 * kept as JSON text, so that a header survives being read and written again.
 *
 * @property topics the topics, in the order of the line.
 * @property values the values, in the order of the line.
 * @property unknown unknown keys of the object, each with its value as JSON.
 */
public data class BagHeader(
    public val topics: List<BagTopic> = emptyList(),
    public val values: List<BagValue> = emptyList(),
    public val unknown: Map<String, String> = emptyMap(),
)

/**
 * A topic as line 1 of a bag describes it.
 *
 * @property name its full name, which is also its column's title on line 2.
 * @property unit its unit; `ul` means none.
 * @property attributes its attributes, in the order of the line.
 * @property unknown unknown keys, each with its value as JSON.
 */
public data class BagTopic(
    public val name: String,
    public val unit: String = "ul",
    public val attributes: List<String> = emptyList(),
    public val unknown: Map<String, String> = emptyMap(),
)

/**
 * A value as line 1 of a bag holds it.
 *
 * @property value what the reader shows.
 * @property unknown unknown keys, each with its value as JSON.
 */
public data class BagValue(public val value: Value, public val unknown: Map<String, String> = emptyMap())
