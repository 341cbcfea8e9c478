"""What SARIF 2.1.0 asks of the objects that Keiko writes: of each the properties that its schema (OASIS,
sarif-schema-2.1.0.json, errata 01) lets it have and those it must, and what the specification asks beyond that.

A property that Keiko does not write is not listed: one that comes new is a fault until it stands here.
"""
import re
from urllib.parse import unquote, urlsplit

# [RFC3986]: characters that a URI may hold as they are, or a byte by two hexadecimal digits.
URI = re.compile(r"(?:[A-Za-z0-9\-._~:/?#\[\]@!$&'()*+,;=]|%[0-9A-F]{2})+\Z")
LEVELS = {"none", "note", "warning", "error"}


def is_uri(value):
    return isinstance(value, str) and bool(URI.match(value)) and bool(urlsplit(value).scheme)


def is_reference(value):
    """Relative to where the file is, or to a base: GitHub refuses or misplaces all else."""
    return isinstance(value, str) and bool(URI.match(value)) and not value.startswith("/") \
        and not urlsplit(value).scheme


def is_base(value):
    """Absolute, and of a folder (3.14.14)."""
    return is_uri(value) and value.endswith("/")


def is_line(value):
    return is_index(value) and value >= 1


def is_fingerprint(value):
    return isinstance(value, str) and bool(re.match(r"[0-9a-f]{16}:[1-9][0-9]*\Z", value))


def is_index(value):
    return isinstance(value, int) and not isinstance(value, bool) and value >= 0


def is_text(value):
    return isinstance(value, str)


def is_words(value):
    """Of a message: braces stand for arguments and brackets before parentheses for links, if not marked (3.11.5, 3.11.6)."""
    return is_text(value) and value != "" and not re.search(r"[{}]", re.sub(r"\{\{|\}\}", "", value)) \
        and not re.search(r"(?<!\\)\]\(", value)


def is_flag(value):
    return isinstance(value, bool)


def is_bag(value):
    return isinstance(value, dict)


# Of each object: its properties, and which of them it must have. A name stands for an object, a list of one for an
# array of those, a list of two for one whose elements are unlike each other.
OBJECTS = {
    "log": ({"$schema": is_uri, "version": {"2.1.0"}, "runs": ["run"]}, {"version", "runs"}),
    "run": ({"tool": "tool", "invocations": ["invocation"], "originalUriBaseIds": "bases", "artifacts": ["artifact", "unlike"],
             "results": ["result"], "properties": is_bag}, {"tool"}),
    "bases": ({"ROOT": "base"}, set()),
    "base": ({"uri": is_base}, {"uri"}),
    "tool": ({"driver": "driver"}, {"driver"}),
    "driver": ({"name": is_text, "version": is_text, "rules": ["rule", "unlike"]}, {"name"}),
    "rule": ({"id": is_text, "name": is_text, "shortDescription": "message", "fullDescription": "message",
              "help": "message", "defaultConfiguration": "configuration"}, {"id", "shortDescription", "fullDescription", "help"}),
    "configuration": ({"level": LEVELS}, set()),
    "invocation": ({"executionSuccessful": is_flag, "toolExecutionNotifications": ["notification"]}, {"executionSuccessful"}),
    "notification": ({"level": LEVELS, "message": "message"}, {"message"}),
    "artifact": ({"location": "place", "roles": [{"analysisTarget"}, "unlike"]}, set()),
    "place": ({"uri": is_reference, "uriBaseId": {"ROOT"}, "index": is_index}, {"uri", "index"}),
    "message": ({"text": is_words}, {"text"}),
    "result": ({"ruleId": is_text, "ruleIndex": is_index, "level": LEVELS - {"none"}, "message": "message",
                "locations": ["location"], "relatedLocations": ["related", "unlike"], "partialFingerprints": "fingerprints",
                "suppressions": ["suppression"], "properties": is_bag}, {"ruleId", "level", "message", "locations", "partialFingerprints"}),
    "fingerprints": ({"primaryLocationLineHash": is_fingerprint}, {"primaryLocationLineHash"}),
    "suppression": ({"kind": {"inSource", "external"}, "status": {"accepted", "underReview", "rejected"},
                     "justification": is_text}, {"kind"}),
    "location": ({"physicalLocation": "physical", "logicalLocations": ["logical", "unlike"]}, {"physicalLocation"}),
    "related": ({"id": is_index, "physicalLocation": "physical", "message": "message"}, {"id", "physicalLocation", "message"}),
    "physical": ({"artifactLocation": "place", "region": "region"}, {"artifactLocation", "region"}),
    "region": ({"startLine": is_line}, {"startLine"}),
    "logical": ({"name": is_text, "fullyQualifiedName": is_text, "kind": {"seam", "face"}}, set()),
}


def faults_of(value, rule, path):
    if isinstance(rule, list):
        if not isinstance(value, list):
            return [f"{path}: is no array"]
        same = len(rule) > 1 and any(one in value[:i] for i, one in enumerate(value))
        return [f"{path}: has one twice"] * same + [
            fault for i, one in enumerate(value) for fault in faults_of(one, rule[0], f"{path}[{i}]")]
    if isinstance(rule, set):
        return [] if is_text(value) and value in rule else [f"{path}: {value!r} is none of {sorted(rule)}"]
    if not isinstance(rule, str):
        return [] if rule(value) else [f"{path}: {value!r} is not {rule.__name__}"]
    properties, required = OBJECTS[rule]
    if not isinstance(value, dict):
        return [f"{path}: is no object"]
    faults = [f"{path}: has no {name}" for name in sorted(required - set(value))]
    faults += [f"{path}: may not have {name}" for name in sorted(set(value) - set(properties))]
    for name in sorted(set(value) & set(properties)):
        faults += faults_of(value[name], properties[name], f"{path}.{name}")
    return faults


# Of one run: what GitHub code scanning takes, and of each result the locations that it shows.
MOST_RESULTS, MOST_LOCATIONS = 25_000, 100


def path_of(run, place):
    """The path that an artifactLocation stands for."""
    base = run["originalUriBaseIds"][place["uriBaseId"]]["uri"] if "uriBaseId" in place else ""
    return unquote(urlsplit(base + place["uri"]).path)


def limit_faults(run):
    faults = [f"has {len(run['results'])} results"] * (len(run["results"]) > MOST_RESULTS)
    for i, result in enumerate(run["results"]):
        if not 1 <= len(result["locations"]) <= MOST_LOCATIONS:
            faults.append(f"result {i}: has {len(result['locations'])} locations")
    if len({"suppressions" in result for result in run["results"]}) > 1:  # 3.27.23
        faults.append("some results have suppressions, others not")
    hashes = [result["partialFingerprints"]["primaryLocationLineHash"] for result in run["results"]]
    return faults + ["two results have one fingerprint"] * (len(set(hashes)) < len(hashes))


def reference_faults(run):
    """Where a result points to another rule or file than it names (3.27.6, 3.4.5)."""
    rules, artifacts = run["tool"]["driver"]["rules"], run["artifacts"]
    faults = [f"artifact {i}: is told as {artifact['location']['index']}" for i, artifact in enumerate(artifacts)
              if artifact["location"].get("index", i) != i]
    for i, result in enumerate(run["results"]):
        rule = result["ruleIndex"]
        if rule >= len(rules) or rules[rule]["id"] != result["ruleId"]:
            faults.append(f"result {i}: rule {rule} is not {result['ruleId']}")
        for location in result["locations"] + result.get("relatedLocations", []):
            place = location["physicalLocation"]["artifactLocation"]
            if place["index"] >= len(artifacts) or artifacts[place["index"]]["location"] != place:
                faults.append(f"result {i}: file {place['index']} is not {place['uri']}")
    return faults


def faults_of_log(log):
    """All that a log breaks, a line each."""
    return faults_of(log, "log", "log") or [fault for run in log["runs"]
                                            for fault in reference_faults(run) + limit_faults(run)]
