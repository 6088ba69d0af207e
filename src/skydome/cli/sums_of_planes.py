"""The numbers of a year on planes: sums of each plane, as JSON and as rows for people."""

from typing import Any

from skydome.cli.printing import fact_rows


def facts_of(light: Any) -> dict[str, Any]:
    """Sums of each plane, with their units in the names."""
    from skydome.years.planes.sums import monthly_sums

    sums = monthly_sums(light)
    planes = [facts_of_plane(light.isel(plane=k), sums.isel(plane=k)) for k in range(light.sizes["plane"])]
    told = {name: light.attrs[name] for name in ("shift", "closure", "decomposition") if name in light.attrs}
    place = {name: float(light.attrs[name]) for name in ("latitude", "longitude", "altitude", "utc_offset")}
    return {
        "site": light.attrs["title"],
        "place": place,
        "hours": light.sizes["time"],
        "missing_hours": float(sums["missing_hours"].sum()),
        "transposition": light.attrs["transposition"],
        "ground_albedo": light.attrs["albedo"],
        **told,
        "planes": planes,
    }


def facts_of_plane(light: Any, sums: Any) -> dict[str, Any]:
    """One plane's sums, in all, by part and by month."""
    whole = sums.sum("month")
    parts = {name: round(float(whole[f"{name}_irradiation"]), 2) for name in ("sky", "sun", "reflected")}
    lit = light["illuminance"].values[light["illuminance"].values > 0]
    return {
        "plane": str(light["plane"].values),
        "sky_view_factor": round(float(light["sky_view_factor"]), 4),
        "irradiation_kwh_m2": parts | {"total": round(float(whole["irradiation"]), 2)},
        "light_exposure_klx_h": round(float(whole["light_exposure"]), 1),
        "mean_daylight_lx": round(float(lit.mean()), 1) if lit.size else 0.0,
        "monthly_irradiation_kwh_m2": {
            int(month): round(float(value), 2)
            for month, value in zip(sums["month"].values, sums["irradiation"].values, strict=True)
        },
    }


def year_rows(facts: dict[str, Any]) -> dict[str, str]:
    """The same for people: a row a plane."""
    if "sites" in facts:
        return fact_rows(facts)
    rows = {"site": facts["site"], "hours": f"{facts['hours']:,}"}
    if facts["missing_hours"]:
        rows["missing"] = f"{facts['missing_hours']:,.0f} h, counted as 0"
    rows["sky on planes"] = f"{facts['transposition']}, ground {facts['ground_albedo']:g}"
    for plane in facts["planes"]:
        parts = plane["irradiation_kwh_m2"]
        by_part = ", ".join(f"{name} {parts[name]:,.0f}" for name in ("sky", "sun", "reflected"))
        exposure, seen = plane["light_exposure_klx_h"], plane["sky_view_factor"]
        rows[plane["plane"]] = (
            f"{parts['total']:,.0f} kWh m⁻² ({by_part}); {exposure:,.0f} klx h; sees {seen:.0%} of the sky"
        )
    texts = {"files": ", ".join(facts["files"]), "notes": "\n".join(facts["notes"])}
    return rows | {name: text for name, text in texts.items() if text}
