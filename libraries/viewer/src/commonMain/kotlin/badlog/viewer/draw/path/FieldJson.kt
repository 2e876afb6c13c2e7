package badlog.viewer.draw.path

import badlog.core.json.JsonMember
import badlog.core.json.JsonReader
import badlog.core.json.JsonValue
import badlog.core.json.quotedJson

/** The exception for a text that is not a field; the message is a sentence with the reason. */
class FieldException(message: String) : IllegalArgumentException(message)

/**
 * Returns the field in [text], a JSON file in the format of WPILib's dashboards. `field-image` is the name of a picture beside it;
 * `field-corners` has the field's corners `top-left` and `bottom-right` in the picture's pixels; `field-size` is the length and width in
 * `field-unit`, feet or meters.
 *
 * @throws FieldException if the text is not a field.
 */
fun fieldOfJson(text: String): Field {
    val members = JsonReader.readObject(text) ?: throw FieldException("It is not a JSON object; select the field’s .json file.")
    val corners = members["field-corners"]?.members
    val (left, top) = pair(corners, "top-left")
    val (right, bottom) = pair(corners, "bottom-right")
    if (right <= left || bottom <= top) throw FieldException("“bottom-right” is not below and to the right of “top-left”; swap them.")
    val unit = members["field-unit"]?.text?.lowercase()
    val meters = when (unit) {
        "foot", "feet", "ft" -> FOOT
        "meter", "meters", "m" -> 1.0
        else -> throw FieldException("“field-unit” is neither “foot” nor “meter”; write one of them.")
    }
    val (length, width) = pair(members, "field-size").map { it * meters }
    if (!(length in SIZES && width in SIZES)) {
        throw FieldException(
            "“field-size” is not the size of a field; give its length and width, as [54, 27].",
        )
    }
    val image = members["field-image"]?.text ?: throw FieldException("“field-image” is missing; name the picture beside the file.")
    return Field(length, width, FieldImage(image, left, top, right, bottom))
}

/** Returns [field], which must have a picture, in the format that [fieldOfJson] reads. */
internal fun fieldJson(field: Field): String = checkNotNull(field.image).run {
    "{\"field-image\":${quotedJson(source)},\"field-corners\":{\"top-left\":[$left,$top],\"bottom-right\":[$right,$bottom]}," +
        "\"field-size\":[${field.length},${field.width}],\"field-unit\":\"meter\"}"
}

private operator fun List<JsonMember>?.get(key: String): JsonValue? = this?.findLast { it.key == key }?.value

private fun pair(members: List<JsonMember>?, key: String): List<Double> {
    val numbers = members[key]?.items?.mapNotNull { it.json.toDoubleOrNull()?.takeIf(Double::isFinite) }
    return numbers?.takeIf { it.size == 2 } ?: throw FieldException("“$key” is not a pair of numbers; write it as [x, y].")
}

private const val FOOT = 0.3048
private val SIZES = 0.1..1000.0
