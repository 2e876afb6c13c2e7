package badlog.page.dom

/** Returns a JavaScript object with these members, the form in which libraries take their options. */
internal fun json(vararg members: Pair<String, Any?>): dynamic {
    val json = js("({})")
    for ((name, value) in members) json[name] = value
    return json
}
