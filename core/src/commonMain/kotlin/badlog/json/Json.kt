package badlog.json

/**
 * A value of a JSON text.
 *
 * @property json the value as it stands in the text.
 * @property text what it says, where it is a string; else null.
 * @property items its items, where it is an array; else null.
 * @property members its members in order, where it is an object; else null.
 */
public class JsonValue internal constructor(
    public val json: String,
    public val text: String? = null,
    public val items: List<JsonValue>? = null,
    public val members: List<JsonMember>? = null,
)

/**
 * A member of a JSON object.
 *
 * @property key its name, which another member may have too.
 */
public class JsonMember internal constructor(public val key: String, public val value: JsonValue)
