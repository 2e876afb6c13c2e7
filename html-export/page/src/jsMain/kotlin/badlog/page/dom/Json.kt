package badlog.page.dom

/** Returns a JavaScript object with [members], the form in which libraries accept options. */
internal fun json(vararg members: Pair<String, Any?>): dynamic {
    val json = js("({})")
    for ((name, value) in members) json[name] = value
    return json
}
