#include "analyzer/tapestry/synthesis/medoids.hpp"

#include <algorithm>

namespace vitrine::analyzer {

namespace {

std::size_t at(int i) {
    return static_cast<std::size_t>(i);
}

}  // namespace

Medoids::Medoids(const Affinity& costs)
    : costs_(costs),
      is_medoid_(at(costs.frames()), false),
      services_(at(costs.frames()), {.cost = costs.far(), .second = costs.far()}),
      loss_(at(costs.frames()), 0) {}

double Medoids::cost() const {
    double sum = 0;
    for (const Service& service : services_)
        sum += service.cost;
    return sum;
}

double Medoids::gain(int frame) const {
    double gain = 0;
    const Service* service = &services_[at(costs_.first(frame))];
    for (const float cost : costs_.shown_by(frame)) {
        gain += std::max(0.F, service->cost - cost);
        ++service;
    }
    return gain;
}

double Medoids::gain_after(int frame, int before) const {
    double gain = 0;
    int i = costs_.first(frame);
    for (const float cost : costs_.shown_by(frame)) {
        gain += std::max(0.F, std::min(services_[at(i)].cost, costs_.at(i, before)) - cost);
        ++i;
    }
    return gain;
}

void Medoids::offer(Service& service, int medoid, float cost) const {
    if (cost < service.cost) {
        service.second = service.cost;
        service.second_by = service.by;
        service.cost = cost;
        service.by = medoid;
    } else if (cost < service.second) {
        service.second = cost;
        service.second_by = medoid;
    }
}

void Medoids::add(int frame) {
    is_medoid_[at(frame)] = true;
    sorted_.insert(std::ranges::lower_bound(sorted_, frame), frame);
    int i = costs_.first(frame);
    for (const float cost : costs_.shown_by(frame)) {
        Service& service = services_[at(i++)];
        if (service.by >= 0) loss_[at(service.by)] -= service.second - service.cost;
        offer(service, frame, cost);
        if (service.by >= 0) loss_[at(service.by)] += service.second - service.cost;
    }
}

void Medoids::swap_changes(int in, int from, int to, std::vector<double>& changes) const {
    changes.assign(loss_.begin() + from, loss_.begin() + to);
    double common = 0;
    const Service* service = &services_[at(costs_.first(in))];
    for (const float cost : costs_.shown_by(in)) {
        const bool is_ours = service->by >= from && service->by < to;
        if (cost < service->cost) {
            common += cost - service->cost;
            if (is_ours) changes[at(service->by - from)] += service->cost - service->second;
        } else if (cost < service->second && is_ours) {
            changes[at(service->by - from)] += cost - service->second;
        }
        ++service;
    }
    for (double& change : changes)
        change += common;
}

void Medoids::serve_anew(int frame) {
    Service& service = services_[at(frame)];
    service = {.cost = costs_.far(), .second = costs_.far()};
    const auto first = std::ranges::lower_bound(sorted_, frame - costs_.band());
    const auto last = std::upper_bound(first, sorted_.end(), frame + costs_.band());
    for (auto medoid = first; medoid != last; ++medoid)
        offer(service, *medoid, costs_.at(frame, *medoid));
}

void Medoids::swap(int out, int in) {
    add(in);
    is_medoid_[at(out)] = false;
    sorted_.erase(std::ranges::lower_bound(sorted_, out));
    for (int i = costs_.first(out); i < costs_.last(out); ++i) {
        const Service before = services_[at(i)];
        if (before.by != out && before.second_by != out) continue;
        loss_[at(before.by)] -= before.second - before.cost;
        serve_anew(i);
        const Service& after = services_[at(i)];
        if (after.by >= 0) loss_[at(after.by)] += after.second - after.cost;
    }
    loss_[at(out)] = 0;
}

}  // namespace vitrine::analyzer
