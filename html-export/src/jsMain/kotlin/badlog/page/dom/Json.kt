package badlog.page.dom

/** A JavaScript object with these members, as libraries take their options. */
internal fun json(vararg members: Pair<String, Any?>): dynamic {
    val json = js("({})")
    for ((name, value) in members) json[name] = value
    return json
}
