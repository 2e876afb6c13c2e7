package badlog.bag

internal actual fun parseJsonObject(text: String): List<JsonMember>? {
    val parsed: dynamic = try {
        JSON.parse<dynamic>(text)
    } catch (_: Throwable) {
        return null
    }
    return if (isObject(parsed)) membersOf(parsed) else null
}

private fun membersOf(json: dynamic): List<JsonMember> {
    val keys = js("Object.keys(json)").unsafeCast<Array<String>>()
    return keys.map { key ->
        val value = json[key]
        JsonMember(key, JSON.stringify(value), stringIn(value), if (isArray(value)) itemsOf(value) else null)
    }
}

private fun itemsOf(array: dynamic): List<JsonItem> = array.unsafeCast<Array<dynamic>>().map { item: dynamic ->
    JsonItem(stringIn(item) ?: JSON.stringify(item), if (isObject(item)) membersOf(item) else null)
}

private fun stringIn(value: dynamic): String? =
    if (jsTypeOf(value) == "string") value.unsafeCast<String>() else null

private fun isArray(value: dynamic): Boolean = js("Array.isArray(value)").unsafeCast<Boolean>()

private fun isObject(value: dynamic): Boolean = value != null && jsTypeOf(value) == "object" && !isArray(value)
