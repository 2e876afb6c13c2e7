package badlog.bag

/**
 * A value of a JSON text.
 *
 * @property json the value as it stands in the text.
 * @property text what it says, where it is a string; else null.
 * @property items its items, where it is an array; else null.
 * @property members its members in order, where it is an object; else null.
 */
internal class JsonValue(
    val json: String,
    val text: String? = null,
    val items: List<JsonValue>? = null,
    val members: List<JsonMember>? = null,
)

/** A member of a JSON object. */
internal class JsonMember(val key: String, val value: JsonValue)
